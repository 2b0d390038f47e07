// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <utility>

#include <leastcost/framework/energy/stopping.hpp>
#include "solvers/stopping_test.hpp"

namespace leastcost {

/// Keeps in a caller's path the one of least true cost that a method without an energy has met: what is handed back is
/// never dearer than what was given, whenever and however the method ends.
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
  double cost() const { return cost_; }

  /// The report of a method that has come to rest at a path of the given cost, which need not be the best it has met.
  SolveReport at_rest(SolveLoop& loop, double cost) {
    std::ostringstream out;
    out.precision(12);
    out << "at rest at the cost " << cost;
    return finish(loop, Termination::fixed_point, out.str());
  }
  /// The report about the path that is kept, its relative cost error measured.
  SolveReport finish(SolveLoop& loop, Termination end, std::string message) {
    loop.set_cost_error(measured_cost_error(energy_, path_));
    return loop.finish(end, std::move(message), energy_.value(path_));
  }

 private:
  PathEnergy& energy_;
  CoordinatePath& path_;
  double cost_;
};

}  // namespace leastcost
