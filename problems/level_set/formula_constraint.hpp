// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/problems/level_set/constraint_function.hpp>
#include "problems/formula/formula.hpp"

namespace leastcost {

/// F from formulas: their variables are the coordinates of R^n, each formula is one component.
std::shared_ptr<const ConstraintFunction> make_formula_constraint(Formulas formulas);

}  // namespace leastcost
