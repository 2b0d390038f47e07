// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/bracket/plane/level.hpp"

/// Potentials on one grid: marched, corrected, proved.
namespace leastcost::bracket {

/// From an end: the cost of the straight move, less what the least cost is below it, near it.
Front front_around(const Medium& medium, const Level& level, const EndRegion& region);

/// Marches, `corrections` times with a density for which the central differences of the outcome have the length of n:
/// second order instead of first.
std::vector<double> march(const Level& level, Front& front, int corrections, FastMarching& marching);

/// Proved ratios of |grad u| to n, or dual norms of grad u, in the searched cells outside the regions, but for those
/// where u is nowhere below `cap`; returns the largest, at least 1.
double check(const Level& level, const std::vector<double>& u, const EndRegion& s, const EndRegion& t,
             std::vector<double>& ratios, bool reversed = false, double cap = kInfinity);

/// Lowers the density where the ratio exceeds 1, so that the next march has less of an excess there.
void deflate(const Level& level, const std::vector<double>& ratios, Front& front);

/// The cost from an end to the nodes, or back, nearly, of second order: nothing is proved.
struct DistanceField {
  EndRegion region;
  std::vector<double> u;
  Front front;  ///< with the density that it was marched with
};
DistanceField distance_field(const Medium& medium, const Level& level, const EndRegion& region, FastMarching& marching);

/// A proved lower bound of the cost from an end to any place: min(u, cap) / ratio + offset outside the region of the
/// end, its cone within. Beyond the cap u may be as steep as it likes.
struct DistanceBound {
  EndRegion region;
  std::vector<double> u;
  double cap = kInfinity, ratio = 1, offset = 0;
};
DistanceBound distance_bound(const Level& level, DistanceField field, double cap, FastMarching& marching);

}  // namespace leastcost::bracket
