// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/chain_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/energy/chain_model.hpp>
#include "framework/newton/bounded_step.hpp"
#include "framework/newton/bundle.hpp"
#include "framework/problem/place_rounding.hpp"

namespace leastcost {
namespace {

constexpr int kNewtonHalvings = 40;
constexpr int kHalvingsAmongBounds = 20;  ///< which steps heed beforehand
constexpr double kAbsurd = 100;           ///< times as much energy as before: a step among bounds is far too long
constexpr double kCrawl = 0.01;           ///< of the predicted gain: less, among bounds, leads nowhere
constexpr int kMostCrawls = 5;            ///< in a row
constexpr int kMostIdle = 8;              ///< steps in a row that do not halve the least error on the cost
constexpr int kMostStalled = 30;          ///< the same among bounds, where steps that are cut short may come free again
constexpr double kStepOfTolerance = 0.1;  ///< of the root of the tolerance: cost is of second order in steps

class NewtonSolve {
 public:
  NewtonSolve(PathEnergy& energy, CoordinatePath& path, const Limits& limits, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        kinked_(energy.problem().manifold->shape() == Shape::polyhedral),
        loop_(energy, path, limits, monitor),
        bounded_(energy) {}

  SolveReport run() {
    if (!model_.evaluate(energy_, path_))
      return loop_.finish(Termination::non_finite, "the gradient is not finite", model_.value);
    model_.solve(energy_, path_, HessianKind::exact);
    for (;;) {
      loop_.record(model_.value, model_.cost_error, largest_move_);
      if (stationary()) return stationary_report();
      if (stalls()) return stuck_report();
      if (jitters()) return loop_.finish(Termination::round_off, "no decrease above rounding", model_.value);
      if (const std::optional<Termination> end = loop_.must_end(path_)) return loop_.finish(*end, "", model_.value);
      const double before = model_.value;
      predicted_ = model_.decrement / 2;
      const bool moved = undecided() ? take_unit_step() : search() || search_again();
      if (kinked_ && !(before - model_.value > kKinkedGain * predicted_))
        return descend_by_bundles(energy_, path_, loop_);
      if (!moved) return stuck_report();
      crawled_ = bounded_.possible() && !undecided() && before - model_.value < kCrawl * predicted_ ? crawled_ + 1 : 0;
      if (crawled_ == kMostCrawls) return stuck_report();
    }
  }

 private:
  /// The predicted decrease drowns in the rounding of E.
  bool undecided() const { return model_.decrement / 2 <= rounding_slack(model_.value, path_.segment_count()); }

  /// Counted only with the Hessian that the problem deserves, and once a whole step has been taken.
  bool stationary() const {
    if (kinked_) return model_.cost_error <= std::max(kKinkedTolerance, loop_.limits().tolerance);
    const bool right_model = model_.exact || !energy_.has_exact_hessian();
    return right_model && unit_ && model_.cost_error <= loop_.limits().tolerance &&
           (largest_move_ <= kStepTolerance * extent() || rests());
  }

  /// Among bounds, where a step may take a program: what is left to go, if a solve is to be less exact than by default.
  bool rests() const {
    if (!bounded_.possible()) return false;
    const double step = kStepOfTolerance * std::sqrt(loop_.limits().tolerance);
    return step > kStepTolerance && model_.moves.colwise().norm().maxCoeff() <= step * extent();
  }

  /// The rounding of positions that a chart computes keeps the error from falling further.
  bool jitters() {
    constexpr double kRoom = 16;
    if (kinked_ || bounded_.possible() || idle_steps() < kMostIdle) return false;
    idle_ = 0;
    const double rounding = place_rounding(energy_.problem(), path_);
    return model_.cost_error <= kRoom * rounding * rounding;
  }

  /// Where walls leave a point hardly any room, every step may be cut short for as long as steps last. Only if a solve
  /// is to be less exact than by default, as in replans: others may come free after more of them, and be certified.
  bool stalls() {
    if (!bounded_.possible() || !(loop_.limits().tolerance > kChainNewtonLimits.tolerance)) return false;
    return idle_steps() >= kMostStalled;
  }

  /// Steps in a row that have not halved the least error so far; asked once per step.
  int idle_steps() {
    idle_ = model_.cost_error < least_error_ / 2 ? 0 : idle_ + 1;
    least_error_ = std::min(least_error_, model_.cost_error);
    return idle_;
  }

  double extent() const { return extent_of(path_.u); }

  bool search() {
    const bool bounded = bounded_.solve(path_, model_);
    const Points& moves = bounded ? bounded_.moves() : model_.moves;
    const double slope = bounded ? bounded_.slope() : -model_.decrement;
    predicted_ = -slope / 2;
    const double slack = rounding_slack(model_.value, path_.segment_count());
    const int most = bounded_.possible() ? kHalvingsAmongBounds : kNewtonHalvings;
    double t = bounded ? 1 : bounded_.part_within(moves), less = 2;
    for (int i = 0; i < most; ++i, t /= less) {
      trial_step_ = t * moves;
      if (bounded && t == 1)
        bounded_.retract(path_, trial_);
      else
        energy_.retract(path_, trial_step_, trial_);
      const double value = energy_.value(trial_);
      less = bounded && value > kAbsurd * model_.value ? 4 : 2;
      if (!(value <= model_.value + kArmijo * t * slope + slack)) continue;
      if (!next_.evaluate(energy_, trial_)) continue;
      next_.solve(energy_, trial_, HessianKind::exact);
      accept(t == 1);
      if (bounded) bounded_.took(largest_move_, i == 0);
      return true;
    }
    return false;
  }

  /// An exact Hessian that just factors may ask for an enormous step: once more with the Gauss-Newton one.
  bool search_again() {
    if (!model_.exact || kinked_) return false;
    model_.solve(energy_, path_, HessianKind::gauss_newton);
    return search();
  }

  /// E cannot decide: the decrement does (strict Armijo refused the last step in 14 of 40 runs, docs/numerics.md
  /// Sec. 3.2).
  bool take_unit_step() {
    energy_.retract(path_, model_.moves, trial_);
    if (!next_.evaluate(energy_, trial_)) return false;
    next_.solve(energy_, trial_, HessianKind::exact);
    // At the floor of rounding the decrement only jitters: a step that does not lower it is the last word.
    if (!(next_.decrement <= model_.decrement)) return false;
    trial_step_ = model_.moves;
    accept(true);
    return true;
  }

  void accept(bool unit) {
    largest_move_ = trial_step_.colwise().norm().maxCoeff();
    unit_ = unit;
    std::swap(path_, trial_);
    std::swap(model_, next_);
  }

  SolveReport stationary_report() {
    const bool distinct = energy_.problem().kernel->strictly_convex();
    return loop_.finish(Termination::converged,
                        distinct ? "" : "H = s has no unique minimiser: the points can slide along the path",
                        model_.value);
  }

  SolveReport stuck_report() {
    const double error = model_.cost_error, tolerance = loop_.limits().tolerance;
    if (undecided() || error <= tolerance) {
      if (model_.exact && error <= tolerance) return stationary_report();
      return loop_.finish(Termination::round_off,
                          model_.exact ? "no decrease above rounding"
                                       : "stationary, but the exact Hessian is not positive definite there",
                          model_.value);
    }
    return loop_.finish(Termination::line_search_failed, "no step along the Newton direction lowers the energy",
                        model_.value);
  }

  PathEnergy& energy_;
  CoordinatePath& path_;
  bool kinked_;
  SolveLoop loop_;
  BoundedStep bounded_;
  ChainModel model_, next_;
  CoordinatePath trial_;
  Points trial_step_;
  double predicted_ = 0;  ///< decrease by the whole step
  double largest_move_ = 0;
  bool unit_ = true;
  int crawled_ = 0;
  int idle_ = 0;
  double least_error_ = std::numeric_limits<double>::infinity();
};

}  // namespace

SolveReport solve_by_newton(PathEnergy& energy, CoordinatePath& path, const Limits& limits, const Monitor& monitor) {
  return NewtonSolve(energy, path, limits, monitor).run();
}

SolveReport ChainNewton::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  return solve_by_newton(energy, path, kChainNewtonLimits, monitor);
}

}  // namespace leastcost
