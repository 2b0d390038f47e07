// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace leastcost {

struct WeightedHeight {
  double height = 0, weight = 0;
};

/// Heights in two groups, below and above the place that parts them best (Otsu 1979: largest variance between them).
struct TwoGroups {
  double apart = 0;   ///< distance of the means of the groups, in the unit of the heights
  double middle = 0;  ///< height half way between the means
  double width = 0;   ///< standard deviation within the groups, of both together
  double share = 0;   ///< part of the weight that the lighter group has
  /// Part of the weight that lies between them, in the middle half of the way from one mean to the other.
  double valley = 0;
  int fewest = 0;  ///< members of the smaller group
};

/// All zero for fewer than two heights. For orientation, apart / width is 2.6 and the valley 0.31 for a normal
/// distribution, 3.5 and 0.25 for a uniform one; two normal ones 6 deviations apart have 6 and 0.07.
TwoGroups two_groups(std::vector<WeightedHeight> heights);

/// How steep it is from one group (heights above or below `middle`) to the other: the median over the smaller group of
/// the difference of heights over the distance, seen from above, to the nearest point of the larger one. Two sheets
/// above each other are steeper than 1, the sides of a crease of less than 90 degrees are not. `places`: where each
/// height stands.
double steepness(const std::vector<WeightedHeight>& heights, const std::vector<Eigen::Vector2d>& places, double middle);

}  // namespace leastcost
