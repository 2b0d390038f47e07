// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// A problem whose target is another image of the same point.
struct TargetImage {
  Problem problem;      ///< to this image of the target
  std::string winding;  ///< turns across each seam, "(1, 0)" or "(1, 0) over pole 1"
};

/// Most images of a family: each is a search of its own.
inline constexpr std::size_t kMostTargetImages = 1000;

/// The images of the target up to `turns` turns either way across each seam of a chart and over its poles, the given
/// one first. Empty where the domain has no seams, and for rings. Throws OptionError("windings") where they are more
/// than kMostTargetImages, or `turns` is negative.
std::vector<TargetImage> target_images(const Problem& problem, int turns);

}  // namespace leastcost
