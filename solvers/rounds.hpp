// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/energy/stopping.hpp>
#include <leastcost/solvers/chain_variables.hpp>
#include <leastcost/solvers/preconditioner.hpp>

namespace leastcost {

/// The options of back ends that minimise a function of a vector.
struct RoundOptions {
  double tolerance = 1e-14;  ///< relative cost error
  int max_evaluations = 20000;
  Preconditioner precondition = Preconditioner::chain;
  int restart = 20;  ///< evaluations between two factorisations
  void fields(FieldVisitor& visit);
};

/// The energy as a function of the variables of one round, for a back end. Remembers the best path it was asked for, so
/// that nothing a back end returns has to be believed, and says when to stop. Never throws: what a cost throws is kept,
/// and thrown again after the back end has returned.
class RoundObjective {
 public:
  virtual ~RoundObjective() = default;
  virtual Index size() const = 0;  ///< number of variables
  /// E at z, and its gradient unless null; +infinity where there is no path or its energy is not finite.
  virtual double operator()(const Eigen::VectorXd& z, Eigen::VectorXd* gradient) = 0;
  /// Whether the back end has to return now: the round is over, a limit is reached, or somebody asked.
  virtual bool must_stop() const = 0;
  /// A finite value above E(0), and a slope that points outward, in place of an infinite one: for back ends that
  /// interpolate between trials.
  virtual double finite_excess(const Eigen::VectorXd& z, Eigen::VectorXd* gradient) const = 0;
  /// How far a component of z may be expected to move.
  virtual double typical_step() const = 0;
  /// Evaluations that are left in this round.
  virtual int evaluations_left() const = 0;
};

/// A minimiser of a function of a vector. Starts at z = 0.
class RoundMinimiser {
 public:
  virtual ~RoundMinimiser() = default;
  /// Returns how the back end says it ended, in its own words. May throw whatever the library throws.
  virtual std::string minimise(RoundObjective& objective) = 0;
};

/// Solves by rounds of a back end (docs/numerics.md Sec. 3.6): variables around the best path so far, so many
/// evaluations, then again around the new best path, with a new factorisation (`precondition: chain`). Without it a
/// round lasts as long as the tangent planes stay near those at its centre. The stopping test, limits, counters and the
/// report are those of every solver.
SolveReport solve_by_rounds(PathEnergy& energy, CoordinatePath& path, const RoundOptions& options,
                            RoundMinimiser& minimiser, const Monitor& monitor);

}  // namespace leastcost
