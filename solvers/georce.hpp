// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

struct GeorceOptions {
  double tolerance = 1e-12;
  int max_iterations = 1000;     ///< steps at most
  int max_evaluations = 100000;  ///< evaluations of the energy at most
  void fields(FieldVisitor& visit);
};

/// GEORCE (arXiv 2505.05961): the discrete energy sum_t u_t' G(x_t) u_t of moves u_t = x_{t+1} - x_t in a chart, with
/// the metric at the start of each move, minimised by alternating its optimality conditions with backtracking: O(n d^3)
/// per iteration, iterations independent of n. G is the metric of the cost, half the second derivative of its square.
/// Its functional is not ours (it is off by O(1/n), a chain of chords by O(1/n^2)): it ends at a fixed point of its
/// own, and the path of least true cost met on the way is returned. Needs an open path in a chart: euclidean or
/// parametric.
class Georce final : public Solver {
 public:
  explicit Georce(GeorceOptions options = {}) : options_(checked(options)) {}
  std::string_view name() const override { return "georce"; }
  std::optional<std::string> cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const override;

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  GeorceOptions options_;
};

}  // namespace leastcost
