// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cloud/two_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

/// Sums over the members of a group; heights relative to the mean of all, so that no digits are lost.
struct Sums {
  double weight = 0, height = 0, square = 0;
  void add(double h, double w) {
    weight += w;
    height += w * h;
    square += w * h * h;
  }
  /// Of the heights around their mean, times the weight.
  double scatter() const { return weight > 0 ? std::max(0.0, square - height * height / weight) : 0; }
};

}  // namespace

TwoGroups two_groups(std::vector<WeightedHeight> heights) {
  TwoGroups best;
  std::erase_if(heights, [](const WeightedHeight& h) { return !(h.weight > 0); });
  if (heights.size() < 2) return best;
  std::sort(heights.begin(), heights.end(),
            [](const WeightedHeight& a, const WeightedHeight& b) { return a.height < b.height; });
  double weight = 0, mean = 0;
  for (const WeightedHeight& h : heights) weight += h.weight, mean += h.weight * h.height;
  mean /= weight;
  Sums all, below;
  for (const WeightedHeight& h : heights) all.add(h.height - mean, h.weight);
  double most = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    below.add(heights[i].height - mean, heights[i].weight);
    const Sums above{all.weight - below.weight, all.height - below.height, all.square - below.square};
    if (!(above.weight > 0)) break;
    const double apart = above.height / above.weight - below.height / below.weight;
    const double between = below.weight * above.weight * apart * apart;
    if (!(between > most)) continue;
    most = between;
    best.apart = apart;
    best.width = std::sqrt((below.scatter() + above.scatter()) / weight);
    best.share = std::min(below.weight, above.weight) / weight;
    best.fewest = static_cast<int>(std::min(i + 1, heights.size() - i - 1));
    best.middle = mean + (above.height / above.weight + below.height / below.weight) / 2;
  }
  const double low = best.middle - best.apart / 4;
  for (const WeightedHeight& h : heights)
    if (h.height > low && h.height < low + best.apart / 2) best.valley += h.weight / weight;
  return best;
}

double mixing(const std::vector<WeightedHeight>& heights, const std::vector<Eigen::Vector2d>& places, double middle) {
  const auto upper = [&](std::size_t i) { return heights[i].height > middle; };
  std::size_t above = 0, crossing = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    std::size_t nearest = i;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < heights.size(); ++j) {
      const double squared = (places[i] - places[j]).squaredNorm();
      if (j == i || !(squared < least)) continue;
      least = squared;
      nearest = j;
    }
    above += upper(i) ? 1 : 0;
    crossing += upper(i) != upper(nearest) ? 1 : 0;
  }
  const auto count = static_cast<double>(heights.size());
  const double part = static_cast<double>(above) / count, at_random = 2 * part * (1 - part);
  return at_random > 0 ? static_cast<double>(crossing) / count / at_random : 0;
}

}  // namespace leastcost
