// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include <leastcost/framework/manifold.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/slopes.hpp"

namespace leastcost::test {

/// What the contract needs to know about a domain besides the domain.
struct ManifoldCase {
  std::shared_ptr<const ConstraintManifold> manifold;
  std::function<Eigen::VectorXd(Random&)> near;  ///< a point near the domain, in coordinates
  std::vector<Eigen::VectorXd> special = {};     ///< nearly degenerate ones: 1e-8 off an edge, a corner, a bound
  double size = 1;                               ///< rounding is measured against it
};

/// A ring through points (every column free), projected.
inline CoordinatePath projected(const ConstraintManifold& manifold, const Points& points) {
  CoordinatePath path{points, {}, true};
  CHECK(manifold.project(path).failed.empty());
  return path;
}

/// Feasible points stay where they are; the residual is the distance.
inline void check_projection(const ManifoldCase& c, const Points& points) {
  CoordinatePath path{points, {}, true};
  const double before = c.manifold->residual(path);
  const Projection projection = c.manifold->project(path);
  CHECK(projection.failed.empty());
  CHECK(projection.moved == Approx(before).margin(1e-14 * c.size));
  CHECK(c.manifold->residual(path) <= 1e-14 * c.size);
  CoordinatePath again = path;
  CHECK(c.manifold->project(again).moved <= 1e-14 * c.size);
  CHECK((again.u - path.u).cwiseAbs().maxCoeff() <= 1e-14 * c.size);
}

/// T'T = I at every point.
inline void check_bases(const ManifoldCase& c, const CoordinatePath& path) {
  const Dimensions dims = c.manifold->dimensions();
  Points bases;
  c.manifold->tangent_bases(path, bases);
  REQUIRE((bases.rows() == dims.coordinate && bases.cols() == dims.tangent * path.u.cols()));
  for (Index i = 0; i < path.u.cols(); ++i) {
    const Points t = bases.middleCols(dims.tangent * i, dims.tangent);
    CHECK((t.transpose() * t - Points::Identity(dims.tangent, dims.tangent)).cwiseAbs().maxCoeff() <= 1e-14);
  }
}

/// A random direction in which column i may move: in the tangent space, or in the plane of its face on a mesh (whose
/// bases are those of smooth normals); on a bound, inwards.
inline Eigen::VectorXd feasible_direction(const ManifoldCase& c, const CoordinatePath& path, Index i, Random& random) {
  const Dimensions dims = c.manifold->dimensions();
  Points basis;
  c.manifold->tangent_bases(path, basis);
  basis = Points(basis.middleCols(dims.tangent * i, dims.tangent));
  if (const auto* domain = dynamic_cast<const HasMesh*>(c.manifold.get())) {
    const auto& [p, q, r] = domain->mesh().face(path.site(i));
    basis << domain->mesh().position(q) - domain->mesh().position(p),
        domain->mesh().position(r) - domain->mesh().position(p);
    basis *= 0.02;
  }
  Eigen::VectorXd v = basis * random.vector(dims.tangent);
  const auto* bounds = dynamic_cast<const HasBounds*>(c.manifold.get());
  Points normals(dims.coordinate, dims.coordinate);
  const int count = bounds ? bounds->active_bounds(path, i, normals) : 0;
  for (int k = 0; k < count; ++k) v -= std::max(0.0, normals.col(k).dot(v)) * normals.col(k);
  return v;
}

/// R(x, 0) = x, dR(x, 0) = id by slope 2, fixed ends stay, the result is feasible.
inline void check_retraction(const ManifoldCase& c, const CoordinatePath& path, Random& random) {
  const Index n = path.u.cols();
  Points step = Points::Zero(path.u.rows(), n);
  CoordinatePath to;
  c.manifold->retract(path, step, to);
  CHECK((to.u - path.u).cwiseAbs().maxCoeff() <= 1e-14 * c.size);
  CHECK(to.sites.size() == path.sites.size());
  for (Index i = 0; i < n; ++i) step.col(i) = feasible_direction(c, path, i, random);
  for (Index i = 0; i < n; ++i) {
    const auto error = [&](double h) {
      c.manifold->retract(path, h * step, to);
      return (to.u - path.u - h * step).col(i).norm();
    };
    CHECK(observed_order(error, 0.1, 1e-14 * c.size) > 2 - kOrderSlack);
  }
  c.manifold->retract(path, 0.3 * step, to);
  CHECK(c.manifold->residual(to) <= 1e-14 * c.size);

  CoordinatePath open = path;
  open.ring = false;
  c.manifold->retract(open, 0.3 * step.middleCols(1, n - 2), to);
  CHECK(to.u.col(0) == open.u.col(0));
  CHECK(to.u.col(n - 1) == open.u.col(n - 1));
  CHECK(to.u.cols() == n);
}

/// Where a point is does not depend on where the search for it began.
inline void check_hints(const ManifoldCase& c, const Points& points, Random& random) {
  const auto* domain = dynamic_cast<const HasMesh*>(c.manifold.get());
  if (!domain) return;
  const CoordinatePath unaided = projected(*c.manifold, points);
  for (int repeat = 0; repeat < 5; ++repeat) {
    CoordinatePath hinted{points, {}, true};
    for (Index i = 0; i < points.cols(); ++i)
      hinted.sites.push_back(random.integer(0, domain->mesh().face_count() - 1));
    CHECK(c.manifold->project(hinted).failed.empty());
    CHECK((hinted.u - unaided.u).cwiseAbs().maxCoeff() <= 1e-14 * c.size);
  }
}

/// Whether a point is a vertex of a mesh: a step off a corner of its border may slide along the other edge.
inline bool is_vertex(const ManifoldCase& c, const Eigen::VectorXd& x) {
  const auto* domain = dynamic_cast<const HasMesh*>(c.manifold.get());
  if (!domain) return false;
  for (const Eigen::Vector3d& p : domain->mesh().positions())
    if ((x - p).norm() < 1e-6 * c.size) return true;
  return false;
}

/// Whether bounds meet at an angle: off the one a step may come up against the other.
inline bool at_an_angle(const Points& normals) {
  const Points products = normals.transpose() * normals;
  return (products - Points::Identity(products.rows(), products.cols())).cwiseAbs().maxCoeff() > 1e-9;
}

/// Outward unit normals, only on a bound: a step along one does not move the point, a step against it does.
inline void check_bounds(const ManifoldCase& c, const CoordinatePath& path) {
  const auto* bounds = dynamic_cast<const HasBounds*>(c.manifold.get());
  if (!bounds) return;
  Points normals(path.u.rows(), path.u.rows());
  for (Index i = 0; i < path.u.cols(); ++i) {
    const int count = bounds->active_bounds(path, i, normals);
    for (int k = 0; k < count; ++k) {
      CHECK(normals.col(k).norm() == Approx(1).epsilon(1e-14));
      if (is_vertex(c, path.u.col(i)) || at_an_angle(normals.leftCols(count))) continue;
      CoordinatePath one{path.u.col(i), {}, true}, to;
      if (!path.sites.empty()) one.sites = {path.site(i)};
      c.manifold->retract(one, 1e-4 * normals.col(k), to);
      CHECK((to.u - one.u).norm() <= 1e-8 * c.size);
      c.manifold->retract(one, -1e-4 * normals.col(k), to);
      CHECK((to.u - one.u).norm() == Approx(1e-4).epsilon(1e-3));
    }
  }
}

/// The contract of ConstraintManifold (framework/manifold.hpp): typical and random points, nearly degenerate ones.
inline void check_manifold_contract(const ManifoldCase& c) {
  Random random;
  const int d = c.manifold->dimensions().coordinate;
  Points points(d, 12);
  for (Index i = 0; i < points.cols(); ++i) points.col(i) = c.near(random);
  Points special(d, static_cast<Index>(c.special.size()));
  for (Index i = 0; i < special.cols(); ++i) special.col(i) = c.special[static_cast<std::size_t>(i)];
  for (const Points& some : {points, special}) {
    if (some.cols() == 0) continue;
    check_projection(c, some);
    check_hints(c, some, random);
    const CoordinatePath path = projected(*c.manifold, some);
    check_bases(c, path);
    check_bounds(c, path);
  }
  check_retraction(c, projected(*c.manifold, points), random);
}

}  // namespace leastcost::test
