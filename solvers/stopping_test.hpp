// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/chain_model.hpp>

namespace leastcost {

/// The stopping test of methods that step without the chain Hessian: the same as everybody's, a relative cost error
/// from the exact chain Hessian (docs/numerics.md Sec. 3.1), but asked for at the start and then ever more rarely, so
/// that it costs little beside their own steps.
class StoppingTest {
 public:
  explicit StoppingTest(double tolerance) : tolerance_(tolerance) {}

  /// Whether the test is worth its price at this iteration: 0, 10, 21, 33, ...: each time ten and a tenth later.
  bool due(int iteration) const { return iteration >= next_; }
  /// Measures the relative cost error at a path whose model has been evaluated; whether the path is stationary.
  bool holds(PathEnergy& energy, const CoordinatePath& path, const ChainModel& at, int iteration);
  /// The last figure measured.
  double cost_error() const { return cost_error_; }

 private:
  double tolerance_;
  int next_ = 0;
  double cost_error_ = 0;
};

/// Relative cost error at a path by the exact chain Hessian, or the Gauss-Newton one where that is not positive
/// definite; +infinity where the energy is not finite. What is said of methods that stop by a rule of their own.
double measured_cost_error(PathEnergy& energy, const CoordinatePath& path);

}  // namespace leastcost
