// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/crossing_word.hpp"

#include <algorithm>
#include <limits>

namespace leastcost {
namespace {

struct Crossed {
  double place = 0;  ///< along the segment
  int letter = 0;
};

bool starts_left(const Round& a, const Round& b) { return a.center.x() < b.center.x(); }

}  // namespace

std::vector<int> crossing_word(const std::vector<Round>& rounds, const Points& path) {
  std::vector<Round> rays;
  for (const Round& round : rounds)
    if (rays.empty() || rays.back().obstacle != round.obstacle) rays.push_back(round);
  std::stable_sort(rays.begin(), rays.end(), starts_left);
  std::vector<int> word;
  std::vector<Crossed> crossed;
  for (Eigen::Index i = 0; i + 1 < path.cols(); ++i) {
    const Eigen::Vector2d a = path.col(i), b = path.col(i + 1);
    if (a.x() == b.x()) continue;  // along no ray: both ends count as left of it, or right
    // A place on the line of a ray counts as left of it; of two rays on one line the first counts as left.
    const bool rightward = a.x() < b.x();
    const Round left{-1, {std::min(a.x(), b.x()), 0}}, right{-1, {std::max(a.x(), b.x()), 0}};
    const auto first = std::lower_bound(rays.begin(), rays.end(), left, starts_left);
    const auto last = std::lower_bound(first, rays.end(), right, starts_left);
    crossed.clear();
    for (auto ray = first; ray != last; ++ray) {
      const double place = (ray->center.x() - a.x()) / (b.x() - a.x());
      if (a.y() + place * (b.y() - a.y()) > ray->center.y())
        crossed.push_back({place, rightward ? ray->obstacle + 1 : -(ray->obstacle + 1)});
    }
    if (!rightward) std::reverse(crossed.begin(), crossed.end());
    for (const Crossed& crossing : crossed) {
      if (!word.empty() && word.back() == -crossing.letter)
        word.pop_back();
      else
        word.push_back(crossing.letter);
    }
  }
  return word;
}

std::optional<bool> of_one_class(const Walls& walls, const Points& a, const Points& b) {
  const auto* made = find_ability<HasRounds>(walls);
  if (made == nullptr) return std::nullopt;
  constexpr double kFar = std::numeric_limits<double>::max();
  const double left = std::min(a.row(0).minCoeff(), b.row(0).minCoeff());
  const double right = std::max(a.row(0).maxCoeff(), b.row(0).maxCoeff());
  const double top = std::max(a.row(1).maxCoeff(), b.row(1).maxCoeff());
  const std::vector<Round> rounds = made->rounds({Eigen::Vector2d(left, -kFar), Eigen::Vector2d(right, top)});
  return crossing_word(rounds, a) == crossing_word(rounds, b);
}

}  // namespace leastcost
