// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/implicit_distance.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/distance/distance_signs.hpp"
#include "problems/distance/foot_points.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

/// f and its gradient at a point.
struct Local {
  Eigen::Matrix<double, 1, 1> f;
  Vector3d g;
  Local(const ConstraintFunction& function, const Vector3d& x) { function.evaluate(x, f, g); }
  bool usable() const { return f.allFinite() && g.allFinite() && g.squaredNorm() > 0; }
};

/// From x onto f = 0 along the gradients, no farther than `most`.
std::optional<Vector3d> slide_down(const ConstraintFunction& function, const Vector3d& x, double most) {
  constexpr int kMostSteps = 20;
  constexpr double kConverged = 1e-9;
  Vector3d y = x;
  for (int i = 0; i < kMostSteps; ++i) {
    const Local here(function, y);
    if (!here.usable()) return std::nullopt;
    const Vector3d step = -here.f[0] / here.g.squaredNorm() * here.g;
    y += step;
    if (!((y - x).norm() <= most)) return std::nullopt;
    if (step.norm() <= kConverged * most) return y;
  }
  return std::nullopt;
}

/// Newton's matrix for y + lambda grad f(y) = x, f(y) = 0, factored; second derivatives of f by differences of its
/// gradient over `step`.
Eigen::PartialPivLU<Eigen::Matrix4d> newton_matrix(const ConstraintFunction& function, const Vector3d& y,
                                                   const Local& here, double lambda, double step) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const Local beside(function, y + step * Vector3d::Unit(axis));
    matrix.col(axis).head<3>() = lambda * (beside.g - here.g) / step;
    matrix(axis, axis) += 1;
  }
  matrix.col(3).head<3>() = here.g;
  matrix.row(3).head<3>() = here.g;
  return Eigen::PartialPivLU<Eigen::Matrix4d>(matrix);
}

/// The foot of x by Newton's method from a point y of the surface near it, with a new matrix where the last gained less
/// than a digit and a half. Nothing when that does not lead to a point at least as near as y.
std::optional<Vector3d> nearest_from(const ConstraintFunction& function, const Vector3d& x, Vector3d y, double scale) {
  constexpr int kMostSteps = 20;
  constexpr double kConverged = 1e-6, kDifference = 1e-5, kFast = 0.03;
  constexpr double kSlack = 1e-3;  // start feet are kept with seven digits
  const double start = (y - x).norm();
  Local here(function, y);
  if (!here.usable()) return std::nullopt;
  double lambda = (x - y).dot(here.g) / here.g.squaredNorm();
  Eigen::PartialPivLU<Eigen::Matrix4d> solver = newton_matrix(function, y, here, lambda, kDifference * scale);
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps; ++i) {
    Eigen::Vector4d rest;
    rest << x - y - lambda * here.g, -here.f[0];
    const Eigen::Vector4d step = solver.solve(rest);
    const double size = step.head<3>().norm();
    if (!step.allFinite() || !(size <= start + scale)) return std::nullopt;
    y += step.head<3>();
    lambda += step[3];
    if (size <= kConverged * scale)
      return (y - x).norm() <= start + kSlack * scale ? std::optional<Vector3d>(y) : std::nullopt;
    here = Local(function, y);
    if (!here.usable()) return std::nullopt;
    if (i > 0 && size > kFast * last) solver = newton_matrix(function, y, here, lambda, kDifference * scale);
    last = size;
  }
  return std::nullopt;
}

class ImplicitDistance final : public DistanceSource {
 public:
  ImplicitDistance(std::shared_ptr<const ConstraintFunction> f, const Eigen::AlignedBox3d& box)
      : f_(std::move(f)), box_(box) {}

  Eigen::AlignedBox3d box() const override { return box_; }
  std::optional<Vector3d> foot(const Vector3d& x) const override {
    const double size = box_.diagonal().norm();
    const std::optional<Vector3d> start = slide_down(*f_, x, size);
    return start ? nearest_from(*f_, x, *start, 1e-2 * size) : std::nullopt;
  }

  double exact_cells() const override {
    return 16;
  }  // cheap, and the coarser grids of the geometry error have cells twice as large
  std::vector<double> sample(const GridShape& shape, double exact, const BuildProgress& progress) const override {
    FootPointGrid field(shape);
    std::vector<std::int8_t> signs(shape.nodes());
    start(field, signs, progress);
    spread_feet(field, progress);
    refine(field, exact, progress);
    check_signs(shape, field.distance, signs);
    for (std::size_t i = 0; i < signs.size(); ++i)
      if (signs[i] < 0) field.distance[i] = -field.distance[i];
    return std::move(field.distance);
  }

 private:
  template <class Visit>
  static void for_slabs(const GridShape& shape, const BuildProgress& progress, const char* phase, Visit visit) {
    for (int k = 0; k < shape.count[2]; ++k) {
      report(progress, static_cast<double>(k) / shape.count[2], phase);
      for (int j = 0; j < shape.count[1]; ++j)
        for (int i = 0; i < shape.count[0]; ++i) visit(shape.index(i, j, k), shape.node(i, j, k));
    }
  }

  /// Signs everywhere, feet near the surface.
  void start(FootPointGrid& field, std::vector<std::int8_t>& signs, const BuildProgress& progress) const {
    constexpr double kNear = 2, kFarthest = 4;  // cells
    bool any = false;
    for_slabs(field.shape, progress, "feet near the surface", [&](std::size_t node, const Vector3d& x) {
      const Local here(*f_, x);
      signs[node] = std::isnan(here.f[0]) ? std::int8_t{0} : here.f[0] < 0 ? std::int8_t{-1} : std::int8_t{1};
      const double cell = field.shape.cell;
      if (!here.usable() || std::abs(here.f[0]) > kNear * cell * here.g.norm()) return;
      const std::optional<Vector3d> y = slide_down(*f_, x, kFarthest * cell);
      if (!y) return;
      any = true;
      field.set(node, *y, (x - *y).norm());
    });
    if (!any)
      throw InputError("no zero of f near a node of the grid: " + text(field.shape) + " from " +
                       point_text(field.shape.origin) + " to " + point_text(field.shape.upper()) +
                       " (the surface is outside the box, or between the nodes: use a larger box or a smaller cell)");
  }

  void refine(FootPointGrid& field, double exact, const BuildProgress& progress) const {
    for_slabs(field.shape, progress, "distances from the surface", [&](std::size_t node, const Vector3d& x) {
      if (!(field.distance[node] <= exact + field.shape.cell)) return;  // what was handed on is an upper bound
      const std::optional<Vector3d> y = nearest_from(*f_, x, field.foot(node), field.shape.cell);
      if (y) field.distance[node] = (x - *y).norm();
    });
  }

  static void check_signs(const GridShape& shape, const std::vector<double>& distance,
                          const std::vector<std::int8_t>& signs) {
    constexpr double kSlack = 1.5;
    for (int k = 0; k < shape.count[2]; ++k)
      for (int j = 0; j < shape.count[1]; ++j)
        for (int i = 0; i < shape.count[0]; ++i) {
          const std::size_t here = shape.index(i, j, k);
          if (signs[here] > 0) continue;
          if (signs[here] == 0)
            throw InputError("f has no finite value at " + point_text(shape.node(i, j, k)) +
                             ", a node of the grid: use a smaller box");
          for_neighbours(shape, {i, j, k}, [&](std::size_t next, const std::array<int, 3>&) {
            if (signs[next] > 0 && same_side(distance[here], distance[next], kSlack * shape.cell))
              throw InputError("f changes its sign near " + point_text(shape.node(i, j, k)) +
                               " without a zero there: f has a pole or a fold, or the cell is too large");
          });
        }
  }

  std::shared_ptr<const ConstraintFunction> f_;
  Eigen::AlignedBox3d box_;
};

}  // namespace

std::shared_ptr<const DistanceSource> make_implicit_distance(std::shared_ptr<const ConstraintFunction> f,
                                                             const Eigen::AlignedBox3d& box) {
  return std::make_shared<ImplicitDistance>(std::move(f), box);
}

}  // namespace leastcost
