// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/check/check_manifold.hpp>

#include <algorithm>
#include <cmath>

#include "framework/check/fault_list.hpp"
#include "framework/check/observed_order.hpp"

namespace leastcost {
namespace {

constexpr double kRounding = 1e-14;  // of the size of the domain

struct Check {
  const ConstraintManifold& manifold;
  const CheckManifoldOptions& options;
  Dimensions dims = manifold.dimensions();
  double rounding = kRounding * options.size;
  FaultList faults = {};

  CoordinatePath projected(const Points& points);
  void projection(const Points& points);
  void bases(const CoordinatePath& path, std::mt19937_64& engine);
  Points directions(const CoordinatePath& path, std::mt19937_64& engine) const;
  void retraction(const CoordinatePath& path, std::mt19937_64& engine);
  void second_order(const CoordinatePath& path, const Points& step);
  void bounds(const CoordinatePath& path);
  void chart(const HasChart& chart, const CoordinatePath& path, std::mt19937_64& engine);
  void poles(const HasChart& chart, const CoordinatePath& path);
};

double largest(const Points& x) { return x.size() > 0 ? x.cwiseAbs().maxCoeff() : 0; }

/// A ring through points (every column free), on the domain.
CoordinatePath Check::projected(const Points& points) {
  CoordinatePath path{points, {}, true};
  faults.at_most("projection", static_cast<double>(manifold.project(path).failed.size()), 0,
                 "points near the domain that could not be projected");
  return path;
}

void Check::projection(const Points& points) {
  CoordinatePath path{points, {}, true};
  const double before = manifold.residual(path);
  const Projection projection = manifold.project(path);
  faults.at_most("projection", static_cast<double>(projection.failed.size()), 0,
                 "points near the domain that could not be projected");
  const double distance = (path.u - points).colwise().norm().maxCoeff();
  faults.at_most("projection", std::abs(projection.moved - distance), 1e-5 * distance + rounding,
                 "`moved` less the distance to the projected point");
  faults.at_most("residual", std::abs(before - distance), 1e-5 * distance + rounding,
                 "residual before project() less the distance to the projected point");
  faults.at_most("residual", manifold.residual(path), rounding, "residual after project()");
  CoordinatePath again = path;
  manifold.project(again);
  faults.at_most("idempotent", largest(again.u - path.u), rounding, "how far a feasible point is moved");
}

void Check::bases(const CoordinatePath& path, std::mt19937_64& engine) {
  Points all;
  manifold.tangent_bases(path, all);
  const bool fits = all.rows() == dims.coordinate && all.cols() == dims.tangent * path.u.cols();
  faults.at_most("dimensions", fits ? 0 : 1, 0, "tangent_bases() is coordinate x (tangent * columns)");
  if (!fits) return;
  for (Index i = 0; i < path.u.cols(); ++i) {
    const Points t = all.middleCols(dims.tangent * i, dims.tangent);
    faults.at_most("tangent_bases", largest(t.transpose() * t - Points::Identity(dims.tangent, dims.tangent)), 1e-14,
                   "T'T - I");
    if (manifold.shape() != Shape::smooth || find_ability<HasChart>(manifold) != nullptr) continue;
    if (find_ability<HasBounds>(manifold) != nullptr) continue;  // x + h t may be clamped
    const Eigen::VectorXd v = t * random_matrix(dims.tangent, 1, engine).normalized() * options.step;
    const auto leaves = [&](double h) {
      const CoordinatePath one{path.u.col(i) + h * v, {}, true};
      return manifold.residual(one);
    };
    faults.at_least("tangent_bases", observed_order(leaves, 0.1, rounding), 2 - kOrderSlack,
                    "order at which x + h t leaves the domain");
  }
}

/// Directions in which the columns may move: tangent, in their pieces, on bounds inwards.
Points Check::directions(const CoordinatePath& path, std::mt19937_64& engine) const {
  Points all, v(dims.coordinate, path.u.cols());
  manifold.tangent_bases(path, all);
  for (Index i = 0; i < v.cols(); ++i)
    v.col(i) = all.middleCols(dims.tangent * i, dims.tangent) * random_matrix(dims.tangent, 1, engine) * options.step;
  if (const auto* pieces = find_ability<HasPieces>(manifold)) pieces->into_pieces(path, v);
  const auto* bounds = find_ability<HasBounds>(manifold);
  if (bounds == nullptr) return v;
  Points normals(dims.coordinate, dims.coordinate);
  for (Index i = 0; i < v.cols(); ++i) {
    const int count = bounds->active_bounds(path, i, normals);
    for (int k = 0; k < count; ++k) v.col(i) -= std::max(0.0, normals.col(k).dot(v.col(i))) * normals.col(k);
  }
  return v;
}

void Check::retraction(const CoordinatePath& path, std::mt19937_64& engine) {
  const Index n = path.u.cols();
  const Points step = directions(path, engine);
  CoordinatePath to;
  manifold.retract(path, Points::Zero(dims.coordinate, n), to);
  faults.at_most("retraction", largest(to.u - path.u), rounding, "R(x, 0) - x");
  faults.at_most("retraction", to.sites.size() == path.sites.size() ? 0 : 1, 0, "R(x, 0) has the sites of x");
  for (Index i = 0; i < n; ++i) {
    const auto error = [&](double h) {
      manifold.retract(path, h * step, to);
      return (to.u - path.u - h * step).col(i).norm();
    };
    faults.at_least("retraction", observed_order(error, 0.1, rounding), 2 - kOrderSlack,
                    "order of R(x, h v) - x - h v in h");
  }
  manifold.retract(path, 0.3 * step, to);
  faults.at_most("residual", manifold.residual(to), rounding, "residual after retract()");
  second_order(path, step);

  CoordinatePath open = path;
  open.ring = false;
  manifold.retract(open, 0.3 * step.middleCols(1, n - 2), to);
  const bool same_size = to.u.cols() == n && to.u.rows() == path.u.rows();
  faults.at_most("retraction", same_size ? 0 : 1, 0, "`to` has the size of `from`");
  if (same_size)
    faults.at_most("retraction", largest(to.u.col(0) - open.u.col(0)) + largest(to.u.col(n - 1) - open.u.col(n - 1)), 0,
                   "how far the ends of an open path move");
}

void Check::second_order(const CoordinatePath& path, const Points& step) {
  if (manifold.shape() != Shape::smooth || find_ability<HasChart>(manifold) != nullptr) return;
  if (find_ability<HasBounds>(manifold) != nullptr) return;  // a bound may hold in between
  for (Index i = 0; i < path.u.cols(); ++i) {
    const auto error = [&](double h) {
      CoordinatePath to, nearest = path;
      manifold.retract(path, h * step, to);
      nearest.u += h * step;
      manifold.project(nearest);
      return (to.u - nearest.u).col(i).norm();
    };
    faults.at_least("second_order", observed_order(error, 0.1, rounding), 3 - kOrderSlack,
                    "order at which the retraction agrees with the nearest point");
  }
}

/// Whether bounds meet at an angle: off the one a step may come up against the other.
bool at_an_angle(const Points& normals) {
  return largest(normals.transpose() * normals - Points::Identity(normals.cols(), normals.cols())) > 1e-9;
}

void Check::bounds(const CoordinatePath& path) {
  const auto* bounds = find_ability<HasBounds>(manifold);
  if (bounds == nullptr) return;
  Points normals(dims.coordinate, dims.coordinate);
  for (Index i = 0; i < path.u.cols(); ++i) {
    const int count = bounds->active_bounds(path, i, normals);
    for (int k = 0; k < count; ++k) {
      const Eigen::VectorXd normal = normals.col(k);
      faults.at_most("bounds", std::abs(normal.norm() - 1), 1e-14, "length of an outward normal, less 1");
      // At a corner of a polyhedron a step off one bound may slide along another.
      if (manifold.shape() == Shape::polyhedral || at_an_angle(normals.leftCols(count))) continue;
      CoordinatePath one{path.u.col(i), {}, true}, to;
      if (!path.sites.empty()) one.sites = {path.site(i)};
      const double h = 1e-4 * options.size;
      manifold.retract(one, h * normal, to);
      faults.at_most("bounds", (to.u - one.u).norm(), 1e-4 * h, "how far a step outwards moves a point on a bound");
      manifold.retract(one, -h * normal, to);
      faults.at_most("bounds", std::abs((to.u - one.u).norm() / h - 1), 1e-3, "length of a step inwards, less 1");
    }
  }
}

/// Jacobian and curvature against the embedding, by their slopes along a random direction of all columns.
void Check::chart(const HasChart& chart, const CoordinatePath& path, std::mt19937_64& engine) {
  const int d = dims.coordinate;
  const Index n = path.u.cols();
  Points x, j, h, moved;
  chart.embed(path, x);
  chart.jacobians(path, j);
  const Points weights = random_matrix(dims.ambient, n, engine);
  chart.curvatures(path, weights, h);
  const Points v = random_matrix(d, n, engine).colwise().normalized() * options.step;
  const double floor = 100 * rounding + 1e-15 * largest(x);
  for (Index i = 0; i < n; ++i) {
    const Eigen::VectorXd slope = j.middleCols(d * i, d) * v.col(i);
    const double bend = v.col(i).dot(h.middleCols(d * i, d) * v.col(i));
    const auto change = [&](double t) {
      CoordinatePath ahead = path;
      ahead.u += t * v;
      chart.embed(ahead, moved);
      return Eigen::VectorXd((moved - x).col(i));
    };
    faults.at_least("chart_jacobian",
                    observed_order([&](double t) { return (change(t) - t * slope).norm(); }, 0.1, floor),
                    2 - kOrderSlack, "Taylor slope of the embedding with its Jacobian");
    const auto rest = [&](double t) { return weights.col(i).dot(change(t) - t * slope) - t * t / 2 * bend; };
    faults.at_least("chart_curvature", observed_order(rest, 0.1, floor * weights.col(i).norm()), 3 - kOrderSlack,
                    "Taylor slope of the embedding with its second derivatives");
    const Points block = h.middleCols(d * i, d);
    faults.at_most("chart_curvature", largest(block - block.transpose()), 1e-12 * (largest(block) + 1),
                   "asymmetry of the second derivatives");
  }
}

void Check::poles(const HasChart& chart, const CoordinatePath& path) {
  Points x, image;
  chart.embed(path, x);
  for (const SeamMap& map : chart.poles()) {
    CoordinatePath over = path;
    for (Index i = 0; i < path.u.cols(); ++i) over.u.col(i) = map.apply(path.u.col(i));
    chart.embed(over, image);
    faults.at_most("chart_poles", largest(image - x), 10 * rounding + 1e-14 * largest(x),
                   "distance of the image of a point over a pole");
  }
}

}  // namespace

std::vector<Fault> check_manifold(const ConstraintManifold& manifold, const PointSampler& near, std::mt19937_64& engine,
                                  const CheckManifoldOptions& options) {
  Check check{manifold, options};
  check.faults.at_most("dimensions", check.dims.tangent, check.dims.coordinate, "degrees of freedom of a point");
  const int d = check.dims.coordinate;
  Points points(d, std::max(options.samples, 3)), special(d, static_cast<Index>(options.special.size()));
  const PointSampler in_space = of_dimension(near, d);
  for (const Eigen::VectorXd& point : options.special) check_dimension(point, d);
  for (Index i = 0; i < points.cols(); ++i) points.col(i) = in_space(engine);
  for (Index i = 0; i < special.cols(); ++i) special.col(i) = options.special[static_cast<std::size_t>(i)];
  for (const Points& some : {points, special}) {
    if (some.cols() == 0) continue;
    check.projection(some);
    const CoordinatePath path = check.projected(some);
    check.bases(path, engine);
    check.bounds(path);
  }
  const CoordinatePath path = check.projected(points);
  check.retraction(path, engine);
  if (const auto* chart = find_ability<HasChart>(manifold)) {
    check.chart(*chart, path, engine);
    check.poles(*chart, path);
  }
  return check.faults.take();
}

}  // namespace leastcost
