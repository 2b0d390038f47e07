// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "problems/cells/cell_map.hpp"

namespace leastcost {

struct CellBoundOptions {
  double upper = std::numeric_limits<double>::infinity();  ///< cost of a path that is known: nothing is asked beyond
  double tolerance = 1e-9;                                 ///< relative gap at which it is done
  double most_places = 4e4;                                ///< on the sides of all cells
  std::function<bool()> stop = [] { return false; };
};

struct CellBound {
  double lower = 0;  ///< no path costs less
  int side_points = 0;
  long places = 0;  ///< that were looked at
  bool stopped = false;
};

/// A bound below the cost of all paths over the cells. A function u on the sides, linear between places on them, with
/// |u(p) - u(q)| <= n |p - q| for all p and q around a cell that costs n, is a potential: each leg of a path costs at
/// least what u rises along it. For places p against all of each piece q of a side this is enough: between two pieces
/// |p - q| is linear along the lines on which both move alike (parallel sides) or are scaled alike (sides at right
/// angles), hence so is what is to be shown, whose largest value is then at an end. u comes from a march over the
/// places; where the inequality fails by a factor u is made anew for a cell that is so much cheaper, and what is left
/// at last divides all of u. docs/numerics.md Sec. 4.3.
CellBound bound_in_cells(const CellMap& map, const Eigen::Vector2d& source, const Eigen::Vector2d& target,
                         const CellBoundOptions& options = {});

}  // namespace leastcost
