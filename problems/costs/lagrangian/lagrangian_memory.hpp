// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>

#include "problems/costs/lagrangian/lagrangian_check.hpp"

namespace leastcost {

/// All that the check of a Lagrangian depends on.
struct LagrangianQuestion {
  std::string text;
  std::map<std::string, double> parameters;
  LagrangianBox box;
  int dim = 0;
  bool any_shape = false;
  bool operator==(const LagrangianQuestion& other) const;
};

/// What `check` says, or said when the same was asked in this process: a check may take half a second, and the cells of
/// a study, or the pairs of a run, ask for the same one. The last few answers are kept, refusals (OptionError) too.
/// Safe between threads.
LagrangianCheck remembered_check(const LagrangianQuestion& question, const std::function<LagrangianCheck()>& check);

}  // namespace leastcost
