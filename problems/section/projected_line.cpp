// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/section/projected_line.hpp"

#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

constexpr int kDeepest = 26;  ///< bisections of a piece: 1e-8 of it

}  // namespace

LineProjector::LineProjector(const ConstraintManifold& manifold)
    : manifold_(manifold), one_{Points(manifold.dimensions().coordinate, 1), {}, true} {}

std::optional<Eigen::VectorXd> LineProjector::nearest(const Eigen::VectorXd& x) {
  one_.u.col(0) = x;
  if (!manifold_.project(one_).failed.empty()) return std::nullopt;
  return one_.u.col(0);
}

bool LineProjector::foot(const Eigen::VectorXd& x, Foot& out) {
  std::optional<Eigen::VectorXd> on = nearest(x);
  if (!on) {
    why_ = "the point " + point_text(x) + " of a straight line has no nearest point on the domain" +
           reason_for_failure(manifold_, x);
    return false;
  }
  out = {x, std::move(*on)};
  return true;
}

bool LineProjector::bisect(const Foot& a, const Foot& b, double gap, int depth, std::vector<Eigen::VectorXd>& out) {
  if ((b.on - a.on).norm() <= gap) {
    out.push_back(b.on);
    return true;
  }
  if (depth == kDeepest) {
    why_ = "at " + point_text(a.x) + " the nearest point of the domain jumps from " + point_text(a.on) + " to " +
           point_text(b.on);
    return false;
  }
  Foot middle;
  return foot((a.x + b.x) / 2, middle) && bisect(a, middle, gap, depth + 1, out) &&
         bisect(middle, b, gap, depth + 1, out);
}

bool LineProjector::append(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int pieces, double gap,
                           std::vector<Eigen::VectorXd>& out) {
  Foot before, next;
  if (!foot(a, before)) return false;
  for (int i = 1; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    if (!foot((1 - t) * a + t * b, next) || !bisect(before, next, gap, 0, out)) return false;
    before = next;
  }
  return true;
}

double polyline_length(const std::vector<Eigen::VectorXd>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

CoordinatePath as_open_path(const std::vector<Eigen::VectorXd>& points) {
  CoordinatePath path{Points(points.front().size(), static_cast<Index>(points.size())), {}, false};
  for (std::size_t i = 0; i < points.size(); ++i) path.u.col(static_cast<Index>(i)) = points[i];
  return path;
}

}  // namespace leastcost
