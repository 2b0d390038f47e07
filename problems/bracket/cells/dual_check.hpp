// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/bracket/cost_dual.hpp>
#include "problems/bracket/cells/spline_check.hpp"

namespace leastcost::bracket {

/// What is known of a function on a cell: within `slack` of v + g.d + d'(xx xy; xy yy) d / 2, d from the node on, as
/// computed anywhere in the cell; `size` bounds the sum of the absolute values of the terms.
struct Quadratic {
  double v = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, slack = 0, size = 0;
};

/// The entries of a dual norm on the part of a cell that lies in the box.
struct DualCell {
  Quadratic xx, xy, yy, wx, wy;
};

/// Not finite where nothing is known.
DualCell dual_cell(const CostDual& dual, const Grid<2>& grid, const Place<2>& cell);

/// The least ratio for which H(x, sign grad u) <= ratio is proved on a cell, as proved_ratio.
double proved_dual_ratio(const Net<2>& coefficients, double h, double largest, double sign, const DualCell& cell,
                         const CheckRules<2>& rules = {}, const BlockedParts& blocked = {});

}  // namespace leastcost::bracket
