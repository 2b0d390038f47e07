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

/// Part of the points whose nearest other point, seen from above, is of the other group (height above or below
/// `middle`), over what it would be if the groups were spread at random over the same ground: about 1 for two sheets
/// above each other, small where the groups have grounds of their own (the two sides of a crease, and its edge).
/// `places`: where each height stands.
double mixing(const std::vector<WeightedHeight>& heights, const std::vector<Eigen::Vector2d>& places, double middle);

}  // namespace leastcost
