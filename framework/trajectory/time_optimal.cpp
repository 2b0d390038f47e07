// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/trajectory/time_optimal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// x = (ds/dt)^2 at the first station of an interval, u = d^2 s/dt^2 in it: which of them keep the limits.
struct PathInterval {
  double step = 0;                   ///< of s
  Eigen::VectorXd begin, end, bend;  ///< q' at its stations, q''
  double fastest = kInfinity;        ///< x, by the velocities

  /// The range of u for an x, such that the next x is at most `next`; empty where low > high.
  void range(double x, double next, const Eigen::VectorXd& acceleration, double& low, double& high) const {
    low = -x / (2 * step);
    high = (next - x) / (2 * step);
    for (Index j = 0; j < bend.size(); ++j) {
      limit(begin[j], bend[j] * x, acceleration[j], low, high);
      limit(end[j] + 2 * step * bend[j], bend[j] * x, acceleration[j], low, high);
    }
  }

 private:
  /// |factor u + given| <= most
  static void limit(double factor, double given, double most, double& low, double& high) {
    if (factor == 0) {
      if (std::abs(given) > most) high = -kInfinity;
      return;
    }
    const double a = (-most - given) / factor, b = (most - given) / factor;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
};

std::vector<PathInterval> intervals_of(const BlendedPath& path, const Eigen::VectorXd& velocity, int stations,
                                       SpeedProfile& profile) {
  const std::vector<PathPiece>& pieces = path.pieces();
  const int each = std::max(4, (stations + static_cast<int>(pieces.size()) - 1) / static_cast<int>(pieces.size()));
  std::vector<PathInterval> intervals;
  std::vector<double> at = {0};
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const PathPiece& piece = pieces[p];
    for (int k = 0; k < each; ++k) {
      const double from = piece.from + piece.length() * k / each, to = piece.from + piece.length() * (k + 1) / each;
      if (!(to > from)) continue;
      PathInterval interval{to - from, piece.direction(from), piece.direction(to), piece.bend};
      for (Index j = 0; j < velocity.size(); ++j) {
        const double rate = std::max(std::abs(interval.begin[j]), std::abs(interval.end[j]));
        if (rate > 0) interval.fastest = std::min(interval.fastest, std::pow(velocity[j] / rate, 2));
      }
      intervals.push_back(std::move(interval));
      at.push_back(to);
      profile.piece.push_back(static_cast<Index>(p));
    }
  }
  profile.s = Eigen::Map<const Eigen::VectorXd>(at.data(), static_cast<Index>(at.size()));
  return intervals;
}

/// The greatest x of an interval from which some u leads to an x of at most `next`. Those that do are an interval from
/// 0 on: standing still keeps every limit. Bisection, from below: what is returned has been seen to do.
double controllable(const PathInterval& interval, double most, double next, const Eigen::VectorXd& acceleration) {
  const auto can = [&](double x) {
    double low, high;
    interval.range(x, next, acceleration, low, high);
    return low <= high;
  };
  if (most == kInfinity) {  // nothing moves: as fast as the acceleration lets it
    most = 1;
    while (can(most) && most < 1e300) most *= 4;
  }
  if (can(most)) return most;
  double below = 0, above = most;
  for (int trial = 0; trial < 60; ++trial) {
    const double middle = (below + above) / 2;
    (can(middle) ? below : above) = middle;
  }
  return below;
}

}  // namespace

SpeedProfile time_optimal(const BlendedPath& path, const Eigen::VectorXd& velocity, const Eigen::VectorXd& acceleration,
                          int stations) {
  SpeedProfile profile;
  const std::vector<PathInterval> intervals = intervals_of(path, velocity, stations, profile);
  const auto count = static_cast<Index>(intervals.size());
  Eigen::VectorXd fastest(count + 1);
  fastest[count] = 0;
  for (Index i = count - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    const double before = i > 0 ? intervals[at - 1].fastest : kInfinity;
    fastest[i] = controllable(intervals[at], std::min(before, intervals[at].fastest), fastest[i + 1], acceleration);
  }
  profile.square = profile.time = Eigen::VectorXd::Zero(count + 1);
  for (Index i = 0; i < count; ++i) {
    const PathInterval& interval = intervals[static_cast<std::size_t>(i)];
    double& next = profile.square[i + 1];
    double low, high;
    interval.range(profile.square[i], fastest[i + 1], acceleration, low, high);
    next = std::clamp(profile.square[i] + 2 * interval.step * std::max(low, high), 0.0, fastest[i + 1]);
    profile.time[i + 1] = profile.time[i] + 2 * interval.step / (std::sqrt(profile.square[i]) + std::sqrt(next));
  }
  return profile;
}

}  // namespace leastcost
