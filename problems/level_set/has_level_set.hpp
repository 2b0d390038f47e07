// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <leastcost/problems/level_set/constraint_function.hpp>

namespace leastcost {

/// Ability: the domain is the set of zeros of a function of its ambient space, smooth and curved.
class HasLevelSet {
 public:
  static constexpr std::string_view kAbility = "smooth embedding";
  virtual ~HasLevelSet() = default;
  virtual const ConstraintFunction& function() const = 0;  ///< whose zeros the domain is
};

}  // namespace leastcost
