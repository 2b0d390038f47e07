// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <leastcost/problems/obstacles/walls.hpp>
#include "problems/taut/string_pull.hpp"

namespace leastcost {

struct TangentSearchOptions {
  double tolerance = 1e-9;                ///< relative: how much shorter a path may be and yet be left aside
  std::int64_t max_tangents = 2'000'000;  ///< that are drawn, whether clear or not
  std::function<bool()> stop = {};        ///< asked every now and then
  Eigen::AlignedBox2d box = {};           ///< that paths stay in; empty: the whole plane
};

struct TangentSearchResult {
  bool finished = false;         ///< all paths below the bound given were looked at
  double rounding = 0;           ///< what the bound is lower by, so that rounding does not break it
  double lower_bound = 0;        ///< no path that is clear is shorter
  std::vector<Bend> bends = {};  ///< of the shortest path found below the bound, where there is one
  bool shorter = false;          ///< there is one
  std::int64_t tangents = 0;     ///< that were drawn
};

/// Looks for paths shorter than `upper` among obstacles in the plane that are made of discs (HasRounds; throws
/// InputError otherwise, and where the ends are one point). A shortest path goes along tangents from disc to disc and
/// along their circles: A* over the tangents, aimed by the straight way to the target, each looked at for obstacles
/// when its turn comes only (lazily, as in Dellin and Srinivasa 2016). Tangents that come into an obstacle by less than
/// rounding, and arcs that do by less than their polygons are off, count as clear: so the bound holds, and a path that
/// is found wants a second look.
TangentSearchResult shorter_tangent_path(const Walls& walls, const Eigen::Vector2d& source,
                                         const Eigen::Vector2d& target, double upper,
                                         const TangentSearchOptions& options);

}  // namespace leastcost
