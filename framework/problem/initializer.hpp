// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// A first path as its method found it: any number of points, any spacing. find_path() samples it.
struct FirstPath {
  CoordinatePath path;                ///< from the source to the target, on the domain
  std::optional<int> graph_vertices;  ///< interior vertices of the edge path, where there was a graph (VFCS 5.1)
  std::vector<std::string> notes;     ///< what the user should know about it
};

/// Makes the path that a solver begins with.
class Initializer : public HasAbilities<Initializer> {
 public:
  virtual std::string_view name() const = 0;  ///< its name in configurations
  /// Throws InitializationError that says what was tried.
  virtual FirstPath first_path(const Problem& problem, const Monitor& monitor) const = 0;
};

/// Ability of an initializer: it makes closed paths where the problem is a ring.
class MakesRings {
 public:
  static constexpr std::string_view kAbility = "ring";
  virtual ~MakesRings() = default;
};

}  // namespace leastcost
