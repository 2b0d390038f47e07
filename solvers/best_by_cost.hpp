// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/path_energy.hpp"

namespace leastcost {

/// Remembers the path of least true cost that a method without an energy has met. What is handed back is never dearer than what was given.
class BestByCost {
 public:
  BestByCost(PathEnergy& energy, const CoordinatePath& path) : energy_(energy), path_(path), cost_(energy.cost(path)) {}

  /// The cost of a path, which is kept if it is the least so far.
  double consider(const CoordinatePath& path) {
    const double cost = energy_.cost(path);
    if (cost < cost_) {
      path_ = path;
      cost_ = cost;
    }
    return cost;
  }
  const CoordinatePath& path() const { return path_; }
  double cost() const { return cost_; }

 private:
  PathEnergy& energy_;
  CoordinatePath path_;
  double cost_;
};

}  // namespace leastcost
