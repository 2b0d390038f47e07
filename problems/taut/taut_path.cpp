// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/taut_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "framework/domain/in_parts.hpp"
#include "problems/obstacles/crossing_word.hpp"
#include "problems/taut/string_pull.hpp"
#include "problems/taut/tangent.hpp"
#include "problems/taut/tangent_path.hpp"

namespace leastcost {
namespace {

using Point2 = Eigen::Vector2d;

constexpr Index kAtOnce = 64;                                              ///< moves between two looks at the clock
constexpr double kOfPlaces = 64 * std::numeric_limits<double>::epsilon();  ///< of coordinates
constexpr double kContact = 1e-9;  ///< of the size: what a path in contact may seem to touch by

bool clear(const Walls& walls, const Points& path, const Deadline& deadline) {
  const double slack = kContact * extent_of(path) + kOfPlaces * path.cwiseAbs().maxCoeff();
  bool all = true;
  in_parts(path.cols() - 1, kAtOnce, deadline, [&](Index begin, Index count) {
    for (Index i = begin; all && i < begin + count; ++i)
      all = walls.clearance(path.col(i), path.col(i + 1)).upper >= -slack;
  });
  return all;
}

double length_of(const Points& path) {
  return (path.rightCols(path.cols() - 1) - path.leftCols(path.cols() - 1)).colwise().norm().sum();
}

/// Whether something stands in the way of the short cuts over a corner: of the longest, between the middles of its
/// sides, or of one nearer to the corner, which cannot be moved over what stands there either.
bool is_held(const Walls& walls, const Point2& corner, const Point2& in, const Point2& out, double turn, double least) {
  for (double share = 0.5; share * turn * std::min(in.norm(), out.norm()) > least; share /= 2)
    if (walls.clearance(corner - share * in, corner + share * out).lower < 0) return true;
  return false;
}

}  // namespace

std::optional<TautPath> taut_path(const Walls& walls, const Points& start, double excess, const Deadline& deadline) {
  if (walls.dimension() != 2 || start.cols() < 2 || !clear(walls, start, deadline)) return std::nullopt;
  std::optional<std::vector<Bend>> bends = pull_string(walls, start, deadline);
  if (!bends) return std::nullopt;
  const auto path = TangentPath::make(walls, start.leftCols(1), start.rightCols(1), std::move(*bends), deadline);
  if (!path) return std::nullopt;
  TautPath taut{path->polyline(excess), 0, path->length()};
  taut.length = length_of(taut.polyline);
  if (!of_one_class(walls, start, taut.polyline).value_or(false)) return std::nullopt;
  return taut;
}

double unheld_turn(const Walls& walls, const Points& polyline, const Deadline& deadline) {
  double worst = 0;
  in_parts(std::max<Index>(0, polyline.cols() - 2), kAtOnce, deadline, [&](Index begin, Index count) {
    for (Index i = begin + 1; i <= begin + count; ++i) {
      const Point2 corner = polyline.col(i), in = corner - polyline.col(i - 1), out = polyline.col(i + 1) - corner;
      const double turn = std::abs(turn_between(in, out));
      const double least = kOfPlaces * std::max({corner.cwiseAbs().maxCoeff(), in.norm(), out.norm()});
      if (turn > worst && !is_held(walls, corner, in, out, turn, least)) worst = turn;
    }
  });
  return worst;
}

}  // namespace leastcost
