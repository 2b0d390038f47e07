// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/layers/snell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace leastcost {
namespace {

constexpr double kNoLayer = 2;  ///< a mismatch that no angles have

/// The interface between two layers on which x is; null where there is none.
std::optional<int> interface_at(const LayerStack& stack, int from, int to, const Eigen::VectorXd& x) {
  const int k = std::min(from, to);
  if (std::abs(from - to) != 1 || !stack.lies_on(k, x)) return std::nullopt;
  return k;
}

Crossing crossing_at(const LayerStack& stack, const Points& x, Index i) {
  Crossing c;
  c.place = x.col(i);
  const Eigen::VectorXd before = x.col(i) - x.col(i - 1), after = x.col(i + 1) - x.col(i);
  const auto from = stack.layer_of_leg(x.col(i - 1), x.col(i)), to = stack.layer_of_leg(x.col(i), x.col(i + 1));
  c.mismatch = kNoLayer;
  if (!from || !to) return c;
  c.from = *from;
  c.to = *to;
  c.index_before = stack.index(*from);
  c.index_after = stack.index(*to);
  const auto k = interface_at(stack, *from, *to, x.col(i));
  if (!k) return c;
  c.interface = *k;
  const Eigen::VectorXd u = before.normalized(), v = after.normalized(), normal = stack.normal(*k);
  const Eigen::VectorXd along_u = u - normal.dot(u) * normal, along_v = v - normal.dot(v) * normal;
  const double larger = std::max(c.index_before, c.index_after);
  c.angle_before = std::atan2(along_u.norm(), std::abs(normal.dot(u)));
  c.angle_after = std::atan2(along_v.norm(), std::abs(normal.dot(v)));
  c.slowness = c.index_before * along_u.norm();
  c.mismatch = (c.index_before * along_u - c.index_after * along_v).norm() / larger;
  // A place is known to a few ulps of its coordinates, its direction from the last one in proportion.
  const double ulps = 16 * std::numeric_limits<double>::epsilon() * x.middleCols(i - 1, 3).cwiseAbs().maxCoeff();
  c.rounding = ulps * (1 / before.norm() + 1 / after.norm());
  return c;
}

}  // namespace

std::vector<Crossing> measure_crossings(const LayerStack& stack, const Points& polyline) {
  std::vector<Crossing> all;
  for (Index i = 1; i + 1 < polyline.cols(); ++i) all.push_back(crossing_at(stack, polyline, i));
  if (polyline.cols() == 2 && !stack.layer_of_leg(polyline.col(0), polyline.col(1))) {
    Crossing c;
    c.place = (polyline.col(0) + polyline.col(1)) / 2;
    c.mismatch = kNoLayer;
    all.push_back(c);
  }
  return all;
}

Points without_repeats(const Points& polyline) {
  const double same = 4 * std::numeric_limits<double>::epsilon() * polyline.cwiseAbs().maxCoeff();
  Points out = polyline;
  Index count = 1;
  for (Index i = 1; i < polyline.cols(); ++i) {
    if ((polyline.col(i) - out.col(count - 1)).norm() <= same) continue;
    out.col(count++) = polyline.col(i);
  }
  out.conservativeResize(Eigen::NoChange, count);
  if (count > 1) out.rightCols(1) = polyline.rightCols(1);
  return out;
}

}  // namespace leastcost
