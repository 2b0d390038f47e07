// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/shapes/round_core.hpp"

#include <limits>

#include "problems/shapes/convex_least.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kOfLengths = 32 * std::numeric_limits<double>::epsilon();

}  // namespace

RoundCore::Box RoundCore::core_bounds() const {
  Box box(3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    box.min()[i] = -reach(-Vector3d::Unit(i));
    box.max()[i] = reach(Vector3d::Unit(i));
  }
  return box;
}

double RoundCore::distance(const Vector& x, Eigen::Ref<Vector> away) const {
  Vector3d normal;
  const double distance = distance_of(x, normal);
  away = normal;
  return distance;
}

double RoundCore::distance_of_segment(const Vector& a, const Vector& b, double& t) const {
  const Vector3d from = a, way = b - a;
  const auto cut_at = [&](double at) {
    Cut cut{at};
    cut.value = distance_of(from + at * way, cut.normal);
    cut.slope = cut.normal.dot(way);
    return cut;
  };
  const double accuracy = kOfLengths * std::max(from.cwiseAbs().maxCoeff(), (from + way).cwiseAbs().maxCoeff());
  const ConvexLeast least = convex_least(cut_at, accuracy);
  t = least.meets ? first_zero(cut_at, least.left, least.at, accuracy) : least.at;
  return least.lower;
}

/// Over lines between two sides of the triangle, from their common corner to the third side: the least over each is
/// convex in the place of the line, and the plane that bounds it bounds the others too.
double RoundCore::distance_of_triangle(const std::array<Vector3d, 3>& corners, Vector3d& nearest) const {
  const Vector3d &apex = corners[0], first = corners[1] - apex, second = corners[2] - apex;
  double size = 0;
  for (const Vector3d& corner : corners) size = std::max(size, corner.cwiseAbs().maxCoeff());
  const double accuracy = kOfLengths * size;
  const auto on_line = [&](double line, double at) -> Vector3d {
    return apex + line * (first + at * (second - first));
  };
  const auto over_line = [&](double line) {
    const Vector3d way = line * (second - first);
    return convex_least(
        [&](double at) {
          Cut cut{at};
          cut.value = distance_of(on_line(line, at), cut.normal);
          cut.slope = cut.normal.dot(way);
          return cut;
        },
        accuracy);
  };
  const auto cut_at = [&](double line) {
    const ConvexLeast least = over_line(line);
    Cut cut{line, least.meets ? 0 : least.lower};
    const double change = least.right.slope - least.left.slope;
    const double share = change > 0 ? least.right.slope / change : 1;  // of the left plane: along the line it is level
    cut.normal = share * least.left.normal + (1 - share) * least.right.normal;
    cut.slope = std::min(cut.normal.dot(first), cut.normal.dot(second));
    return cut;
  };
  const ConvexLeast least = convex_least(cut_at, 4 * accuracy);
  nearest = on_line(least.at, over_line(least.at).at);
  return least.lower;
}

}  // namespace leastcost
