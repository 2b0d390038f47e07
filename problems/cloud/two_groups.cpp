// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cloud/two_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

double steepness(const std::vector<WeightedHeight>& heights, const std::vector<Eigen::Vector2d>& places,
                 double middle) {
  std::vector<std::size_t> below, above;
  for (std::size_t i = 0; i < heights.size(); ++i) (heights[i].height > middle ? above : below).push_back(i);
  if (below.size() < above.size()) std::swap(below, above);
  if (above.empty()) return 0;
  std::vector<double> slopes;
  for (const std::size_t i : above) {
    double least = std::numeric_limits<double>::infinity(), rise = 0;
    for (const std::size_t j : below) {
      const double distance = (places[i] - places[j]).norm();
      if (!(distance < least)) continue;
      least = distance;
      rise = std::abs(heights[i].height - heights[j].height);
    }
    slopes.push_back(least > 0 ? rise / least : std::numeric_limits<double>::infinity());
  }
  const auto half = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), half, slopes.end());
  return *half;
}

}  // namespace leastcost
