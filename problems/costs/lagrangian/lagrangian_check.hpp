// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

#include "problems/costs/lagrangian/lagrangian_form.hpp"
#include "problems/formula/formula.hpp"

namespace leastcost {

/// Where a Lagrangian is checked: ambient positions; empty: nowhere is known.
struct LagrangianBox {
  Eigen::VectorXd lower, upper;
  bool known() const { return lower.size() > 0; }
};

/// What was found about F(x, v) in a box. What is refuted is thrown.
struct LagrangianCheck {
  bool proved = false;  ///< by intervals, over all of the box and all directions; else at samples alone
  bool convex = true;   ///< F_vv is positive across v; false only where it need not be
  std::string note;     ///< a sentence for the reader of a result
};

/// Checks that F(x, v) is a cost per length: F > 0 for v != 0, F(x, l v) = l F(x, v) for l > 0, and F_vv positive
/// across v, unless `any_shape`. The variables of the formula are x, then v.
///
/// Directions are the faces v_k = +-1 of a cube, which by homogeneity stand for all: on such a face F_vv is positive
/// across v exactly if it is so in the other components of v (F_vv v = 0). In two and three dimensions boxes of places
/// and directions are halved until intervals decide, or the budget is spent. Throws OptionError of `lagrangian`.
LagrangianCheck check_lagrangian(const Formula& formula, const LagrangianForm& form, const LagrangianBox& box, int dim,
                                 bool any_shape);

}  // namespace leastcost
