// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/tight_string.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/taut/pulled_string.hpp"
#include "problems/taut/unheld_bends.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A force of its own at every vertex, in tensions, the same in all runs: together about as strong as that.
Matrix3Xd aside(Index vertices, int turn, double strong) {
  Matrix3Xd forces(3, vertices);
  for (Index i = 0; i < vertices; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(std::max<Index>(1, vertices - 1));
    forces.col(i) = strong / static_cast<double>(vertices) * 4 *
                    Vector3d(std::sin(3 * t + turn), std::cos(5 * t + 2 * turn), std::sin(7 * t + 3 * turn + 1));
  }
  return forces;
}

/// Pulls a string that has come to rest aside, and lets it go: whether it comes to rest shorter, by more than `least`
/// of its length. Where it does not it stays.
bool leaves_balance(PulledString& string, double strong, double least, const Walls& walls, const Monitor& monitor) {
  bool left = false;
  for (int turn = 0; turn < 2 && !string.failed(); ++turn) {
    PulledString other(walls, string.polyline(), monitor);
    other.pull(aside(other.polyline().cols(), turn, strong));
    other.pull_tight(least);
    if (other.failed() || !(other.length() < (1 - least) * string.length())) continue;
    string.take(other);
    left = true;
  }
  return left;
}

constexpr double kNearly = 0.01;  ///< of the excess that is asked for: what pulls leave

/// Cuts and pulls until a cut gains less than the excess that is asked for. Returns what the last one has gained: where
/// cuts converge, another one gains less.
double refine(PulledString& string, double excess) {
  constexpr double kWorthACut = 0.1;  // of the mean excess of stretches
  constexpr int kLeast = 2, kMost = 20;
  constexpr Index kMostSides = 3000;
  for (int cuts = 0;; ++cuts) {
    const double before = string.length();
    if (cuts > 0) string.cut_short(kWorthACut);
    string.pull_tight(kNearly * excess);
    const double gained = std::max(0.0, before - string.length()), allowed = excess * string.length() / 2;
    const bool tight = cuts >= kLeast && gained <= allowed && string.excess() <= allowed;
    if (tight || string.failed() || cuts >= kMost || string.polyline().cols() > kMostSides) return gained;
  }
}

/// What a string could still gain where no obstacle holds it. How fast what is unheld to the side goes away in a pull
/// says how little the roundness of obstacles leaves to hold it.
double gain_of_unheld(PulledString& string, const Walls& walls, const Deadline& deadline) {
  constexpr double kMostPace = 0.999, kTold = 64 * std::numeric_limits<double>::epsilon();  // of the length
  const double before = unheld_bends(walls, string.polyline(), deadline).sideways;
  string.pull();
  const Unheld unheld = unheld_bends(walls, string.polyline(), deadline);
  if (unheld.sideways <= kTold * string.length()) return unheld.gain + unheld.sideways;
  const double pace = before > 0 ? std::min(kMostPace, std::sqrt(unheld.sideways / before)) : kMostPace;
  return unheld.gain + unheld.sideways / (1 - pace);
}

}  // namespace

std::optional<TightString> tight_string(const Walls& walls, const Points& start, double excess,
                                        const Monitor& monitor) {
  constexpr double kOfPolygons = 1.25, kSafety = 2;
  if (walls.dimension() != 3 || start.cols() < 2 || !(polyline_length(start) > 0)) return std::nullopt;
  PulledString string(walls, start, monitor);
  if (!string.clear()) return std::nullopt;
  constexpr double kRoughly = 1e-5, kStrong = 0.3, kGently = 0.03;
  constexpr int kMostTimes = 4;
  string.straighten();
  string.pull_tight(kRoughly);
  leaves_balance(string, kStrong, kRoughly, walls, monitor);  // coarse strings are cheap: most is found here
  double gained = refine(string, excess);
  for (int k = 0; k < kMostTimes && leaves_balance(string, kGently, excess, walls, monitor); ++k)
    gained = refine(string, excess);
  if (string.failed()) return std::nullopt;
  const double unheld = gain_of_unheld(string, walls, monitor.deadline);
  const double length = string.length();
  return TightString{string.polyline(), length,
                     std::max(gained, kOfPolygons * string.excess()) + kSafety * (unheld + kNearly * excess * length)};
}

}  // namespace leastcost
