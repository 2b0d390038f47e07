// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/problem/problem.hpp>
#include "problems/cells/cell_map.hpp"

namespace leastcost {

/// Ability of a cost: a unit of length costs the same all over a cell.
class HasCostCells {
 public:
  virtual ~HasCostCells() = default;
  virtual const CellMap& cell_map() const = 0;
};

/// Those within the box of a domain, all where it has none.
CellMap cells_in_box(const HasCostCells& cost, const ConstraintManifold& domain);

/// Why a problem is not one of paths over the cells of its cost; empty: it is.
std::string why_no_cells(const Problem& problem);

/// The cells of the cost of a problem within the box of its domain. Throws InputError, which begins with `who`, where
/// it has none, for rings, where points are not free in the plane or a box of it, and for an end without a cell.
CellMap cells_of(const Problem& problem, const std::string& who);

}  // namespace leastcost
