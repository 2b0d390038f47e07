// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/covering.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <set>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/symmetric_eigen.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Corners = std::vector<Vector3d>;
using Ends = Eigen::Matrix<double, 6, 1>;  ///< of an axis

constexpr double kPi = std::numbers::pi;

double volume_of_capsule(double length, double radius) { return kPi * radius * radius * (length + 4.0 / 3 * radius); }

/// A radius that covers in spite of rounding, where coordinates are up to `size`.
double rounded_up(double radius, double size) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  return radius * (1 + 8 * kEpsilon) + 32 * kEpsilon * size + std::numeric_limits<double>::min();
}

/// How far the ends of the axis stay inside the end faces of a bar, whose corners are `side` off the axis, so that the
/// capsule is smallest: the farther in, the thicker it has to be. Any choice covers.
double inset(double length, double side) {
  const auto worth = [&](double in) { return volume_of_capsule(length - 2 * in, std::hypot(side, in)); };
  double low = 0, high = length / 2;
  for (int k = 0; k < 60; ++k) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (worth(a) < worth(b) ? high : low) = worth(a) < worth(b) ? b : a;
  }
  return (low + high) / 2;
}

double distance_from_axis(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  const double square = way.squaredNorm();
  const double t = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
  return (point - from - t * way).norm();
}

double radius_around(const Corners& points, const Ends& ends) {
  double radius = 0;
  for (const Vector3d& point : points)
    radius = std::max(radius, distance_from_axis(point, ends.head<3>(), ends.tail<3>()));
  return radius;
}

/// Evenly spread over the sphere (a spiral with the golden angle).
Corners spread_directions(int count) {
  Corners all;
  const double golden = kPi * (3 - std::sqrt(5.0));
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, ring = std::sqrt(1 - z * z);
    all.emplace_back(ring * std::cos(golden * k), ring * std::sin(golden * k), z);
  }
  return all;
}

/// The points that are farthest out: all that a fit needs to look at, or nearly.
Corners farthest_out(const Corners& points) {
  constexpr int kDirections = 400;
  if (points.size() <= kDirections) return points;
  std::set<std::size_t> chosen;
  for (const Vector3d& way : spread_directions(kDirections)) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (way.dot(points[i]) > way.dot(points[best])) best = i;
    chosen.insert(best);
  }
  Corners out;
  for (const std::size_t i : chosen) out.push_back(points[i]);
  return out;
}

/// Nelder and Mead's simplex (1965) over the ends of the axis; the volume has kinks, which it does not mind.
Ends shrunk(const Corners& points, const Ends& start, double step) {
  constexpr int kSteps = 700;
  struct Corner {
    Ends ends;
    double worth;
  };
  const auto at = [&](const Ends& e) {
    return Corner{e, volume_of_capsule((e.tail<3>() - e.head<3>()).norm(), radius_around(points, e))};
  };
  std::array<Corner, 7> corners;
  corners[0] = at(start);
  for (std::size_t i = 0; i < 6; ++i) corners[i + 1] = at(start + step * Ends::Unit(static_cast<Eigen::Index>(i)));
  const auto by_worth = [](const Corner& a, const Corner& b) { return a.worth < b.worth; };
  for (int k = 0; k < kSteps; ++k) {
    std::sort(corners.begin(), corners.end(), by_worth);
    if (corners[6].worth - corners[0].worth <= 1e-7 * corners[0].worth) break;
    Ends middle = Ends::Zero();
    for (std::size_t i = 0; i < 6; ++i) middle += corners[i].ends / 6;
    Corner& worst = corners[6];
    const Ends way = middle - worst.ends;
    const Corner reflected = at(middle + way);
    if (reflected.worth < corners[0].worth) {
      worst = std::min(reflected, at(middle + 2 * way), by_worth);
    } else if (reflected.worth < corners[5].worth) {
      worst = reflected;
    } else {
      const Corner nearer = at(reflected.worth < worst.worth ? Ends(middle + way / 2) : Ends(middle - way / 2));
      if (nearer.worth < std::min(worst.worth, reflected.worth)) {
        worst = nearer;
        continue;
      }
      for (std::size_t i = 1; i < 7; ++i) corners[i] = at((corners[0].ends + corners[i].ends) / 2);
    }
  }
  return std::min_element(corners.begin(), corners.end(), by_worth)->ends;
}

/// Along each of the principal axes, as long as the points leave it; the best after shrinking.
Ends fitted(const Corners& points) {
  Vector3d center = Vector3d::Zero();
  for (const Vector3d& point : points) center += point / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points) spread += (point - center) * (point - center).transpose();
  const Eigen::MatrixXd axes = symmetric_eigen(spread).vectors;
  Ends best;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3d axis = axes.col(k);
    double low = 0, high = 0, side = 0;
    for (const Vector3d& point : points) {
      const double along = axis.dot(point - center);
      low = std::min(low, along);
      high = std::max(high, along);
      side = std::max(side, (point - center - along * axis).norm());
    }
    const double from = std::min(low + side, (low + high) / 2), to = std::max(high - side, (low + high) / 2);
    Ends ends;
    ends << center + from * axis, center + to * axis;
    for (const double step : {0.1, 0.02}) ends = shrunk(points, ends, step * (high - low + side));
    const double worth = volume_of_capsule((ends.tail<3>() - ends.head<3>()).norm(), radius_around(points, ends));
    if (!(worth < least)) continue;
    least = worth;
    best = ends;
  }
  return best;
}

void check_covered(bool good, const char* key, const char* why) {
  if (!good) throw OptionError(key, why);
}

bool is_length(double x) { return std::isfinite(x) && x > 0; }

}  // namespace

Covering cover_cylinder(double length, double radius) {
  check_covered(is_length(length), "length", "must be greater than 0");
  check_covered(is_length(radius), "radius", "must be greater than 0");
  const double in = inset(length, radius), around = rounded_up(std::hypot(radius, in), length / 2 + radius);
  const Vector3d end(0, 0, length / 2 - in);
  return {{{0, -end, end, around}}, around - std::min(in, radius)};
}

Covering cover_box(const Vector3d& size) {
  check_covered(is_length(size.x()) && is_length(size.y()) && is_length(size.z()), "size",
                "must have three numbers greater than 0");
  constexpr double kMost = 8;
  std::array<Eigen::Index, 3> order = {0, 1, 2};  // longest edge first
  std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) { return size[i] > size[j]; });
  const double length = size[order[0]], width = size[order[1]], height = size[order[2]];
  const double count = std::clamp(std::round(width / height), 1.0, kMost);
  const double side = std::hypot(width / count, height) / 2, in = inset(length, side);
  Covering out;
  const double radius = rounded_up(std::hypot(side, in), length + width);
  for (int k = 0; k < static_cast<int>(count); ++k) {
    Capsule capsule{0, Vector3d::Zero(), Vector3d::Zero(), radius};
    capsule.from[order[1]] = capsule.to[order[1]] = width * ((k + 0.5) / count - 0.5);
    capsule.to[order[0]] = length / 2 - in;
    capsule.from[order[0]] = -capsule.to[order[0]];
    out.capsules.push_back(capsule);
  }
  out.adds = radius - std::min({in, height / 2, width / count / 2});
  return out;
}

Covering cover_points(const Corners& points) {
  check_covered(!points.empty(), "points", "must have at least one point");
  double size = 0;
  for (const Vector3d& point : points) {
    check_covered(point.allFinite(), "points", "must have finite coordinates");
    size = std::max(size, point.cwiseAbs().maxCoeff());
  }
  const Corners outer = farthest_out(points);
  const Ends ends = fitted(outer);
  // The proof: all points, not only those of the fit.
  const double radius = rounded_up(radius_around(points, ends), size + ends.cwiseAbs().maxCoeff());
  Covering out{{{0, ends.head<3>(), ends.tail<3>(), radius}}, 0};
  out.adds = reach_beyond(out.capsules, outer);
  return out;
}

double reach_beyond(const std::vector<Capsule>& capsules, const Corners& points) {
  double most = 0;
  for (const Vector3d& way : spread_directions(400)) {
    double of_points = -std::numeric_limits<double>::infinity(), of_capsules = of_points;
    for (const Vector3d& point : points) of_points = std::max(of_points, way.dot(point));
    for (const Capsule& one : capsules)
      of_capsules = std::max(of_capsules, std::max(way.dot(one.from), way.dot(one.to)) + one.radius);
    most = std::max(most, of_capsules - of_points);
  }
  return most;
}

}  // namespace leastcost
