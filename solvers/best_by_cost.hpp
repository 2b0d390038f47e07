// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/path_energy.hpp"

namespace leastcost {

/// Keeps in a caller's path the one of least true cost that a method without an energy has met: what is handed back is never dearer than what was
/// given, whenever and however the method ends.
class BestByCost {
 public:
  BestByCost(PathEnergy& energy, CoordinatePath& path) : energy_(energy), path_(path), cost_(energy.cost(path)) {}

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
  CoordinatePath& path_;
  double cost_;
};

}  // namespace leastcost
