// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/unit_of_cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <leastcost/problems/chart/is_geographic.hpp>

namespace leastcost {
namespace {

/// Metres from one place to another nearby, both (longitude, latitude) in degrees on WGS84.
double metres_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  constexpr double kDegree = std::numbers::pi / 180, kA = 6378137, kFlattening = 1 / 298.257223563;
  constexpr double kE2 = kFlattening * (2 - kFlattening);
  const double latitude = kDegree * (a[1] + b[1]) / 2, sine = std::sin(latitude);
  const double root = std::sqrt(1 - kE2 * sine * sine);
  const double east = kA / root * std::cos(latitude) * kDegree * std::remainder(b[0] - a[0], 360.0);
  const double north = kA * (1 - kE2) / (root * root * root) * kDegree * (b[1] - a[1]);
  return std::hypot(east, north);
}

bool are_metres(double length, double metres) {
  constexpr double kScale = 0.01;  // that of a projection
  return std::abs(length - metres) <= kScale * metres;
}

}  // namespace

std::string unit_of_cost(const Problem& problem) {
  const std::string& unit = problem.cost->traits().unit;
  const auto* earth = find_ability<IsGeographic>(*problem.manifold);
  const Eigen::VectorXd &from = problem.source.u, &to = problem.target.u;
  if (unit != "length" || earth == nullptr || from.size() == 0 || from.size() != to.size()) return unit;
  constexpr double kPart = 1e-3;  // of the way: nearby, and far above rounding
  Points u(from.size(), 2);
  Eigen::VectorXd way = to - from;
  if (way.isZero()) way[0] = std::max(1.0, from.cwiseAbs().maxCoeff());  // a field from one place
  u << from, from + kPart * way;
  const double metres = metres_between(earth->longitude_latitude(u.col(0)), earth->longitude_latitude(u.col(1)));
  const Points x = positions(*problem.manifold, {u, {}, true});
  const bool known = metres > 0 && (are_metres((x.col(1) - x.col(0)).norm(), metres) ||
                                    are_metres((u.col(1) - u.col(0)).norm(), metres));
  return known ? "m" : unit;
}

}  // namespace leastcost
