// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/least_push.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "framework/base/dense_solves.hpp"

namespace leastcost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kCleared = 1e-9;  ///< of the most that is missing

/// The least step onto all walls of a set, without those that would have to pull.
VectorXd onto(const std::vector<WallToClear>& walls, std::vector<std::size_t>& set) {
  for (;;) {
    if (set.empty()) return VectorXd::Zero(walls.front().slope.size());
    MatrixXd slopes(walls.front().slope.size(), static_cast<Index>(set.size()));
    VectorXd missing(slopes.cols());
    for (Index k = 0; k < slopes.cols(); ++k) {
      const WallToClear& wall = walls[set[static_cast<std::size_t>(k)]];
      slopes.col(k) = wall.slope;
      missing[k] = wall.missing;
    }
    VectorXd step = least_squares(slopes.transpose(), missing);
    const VectorXd pushes = least_squares(slopes, step);
    Index pulling = -1;
    for (Index k = 0; k < pushes.size(); ++k)
      if (pushes[k] < 0 && !walls[set[static_cast<std::size_t>(k)]].exactly &&
          (pulling < 0 || pushes[k] < pushes[pulling]))
        pulling = k;
    if (pulling < 0) return step;
    set.erase(set.begin() + pulling);
  }
}

}  // namespace

std::optional<VectorXd> least_push(const std::vector<WallToClear>& walls) {
  if (walls.empty()) return std::nullopt;
  std::vector<std::size_t> set;
  double most = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (walls[i].exactly) set.push_back(i);
    if (walls[i].exactly || walls[i].missing > 0) most = std::max(most, std::abs(walls[i].missing));
  }
  const std::size_t most_changes = 3 * walls.size() + 8;
  std::set<std::vector<std::size_t>> seen;  // where no step clears all walls, the same sets come again and again
  for (std::size_t changes = 0; changes < most_changes; ++changes) {
    VectorXd step = onto(walls, set);
    std::vector<std::size_t> sorted = set;
    std::sort(sorted.begin(), sorted.end());
    if (!seen.insert(std::move(sorted)).second) return std::nullopt;
    std::size_t next = walls.size();
    double worst = kCleared * most;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const double left = walls[i].missing - walls[i].slope.dot(step);
      if (!(left > worst) || std::find(set.begin(), set.end(), i) != set.end()) continue;
      worst = left;
      next = i;
    }
    if (next == walls.size()) return step.allFinite() ? std::optional<VectorXd>(std::move(step)) : std::nullopt;
    set.push_back(next);
  }
  return std::nullopt;
}

}  // namespace leastcost
