// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/lbfgs.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/stopping.hpp>
#include "framework/newton/bundle.hpp"
#include "solvers/first_move.hpp"
#include "solvers/lbfgs_history.hpp"
#include "solvers/limit_fields.hpp"

namespace leastcost {
namespace {

constexpr double kCurvature = 0.9;
constexpr int kMaxTrials = 40;
constexpr int kMaxKinkedTrials = 6;  ///< bisection cannot find a slope that a kink leaves out

class LbfgsSolve {
 public:
  LbfgsSolve(PathEnergy& energy, CoordinatePath& path, const LbfgsOptions& options, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        chain_(options.precondition == Preconditioner::chain),
        kinked_(energy.problem().manifold->shape() == Shape::polyhedral),
        history_(options.memory),
        loop_(energy, path, {options.tolerance, options.max_iterations, options.max_evaluations}, monitor) {}

  SolveReport run() {
    if (!model_.evaluate(energy_, path_))
      return loop_.finish(Termination::non_finite, "the gradient is not finite", model_.value);
    for (;;) {
      if (chain_) model_.solve(energy_, path_, HessianKind::gauss_newton);
      history_.transport(energy_, model_.frames);
      choose_direction();
      loop_.record(model_.value, error_estimate(), largest_move_);
      if (error_estimate() <= tolerance() && confirmed()) return loop_.finish(Termination::converged, "", model_.value);
      if (const std::optional<Termination> end = loop_.must_end(path_)) return loop_.finish(*end, "", model_.value);
      const double before = model_.value;
      const bool moved = search();
      if (kinked_ && !(before - model_.value > kKinkedGain * -slope_ / 2))
        return descend_by_bundles(energy_, path_, loop_);
      if (moved) continue;
      if (history_.empty()) return stuck_report();
      history_.clear();  // once more from the preconditioner alone
    }
  }

 private:
  void choose_direction() {
    const auto inverse = [this](Eigen::VectorXd& v) {
      if (chain_) energy_.solve(model_.system, v);
    };
    history_.direction(model_.tangent, inverse, direction_);
    slope_ = model_.tangent.dot(direction_);
    if (!(slope_ < 0)) {
      history_.clear();
      history_.direction(model_.tangent, inverse, direction_);
      slope_ = model_.tangent.dot(direction_);
    }
    if (!chain_ && history_.empty()) {  // no scale is known yet: move no point farther than a segment
      const double longest = direction_.reshaped(energy_.problem().manifold->dimensions().tangent, path_.free_count())
                                 .colwise()
                                 .norm()
                                 .maxCoeff();
      const double scale = kFirstMove * mean_segment(path_) / longest;
      direction_ *= scale;
      slope_ *= scale;
    }
    energy_.from_tangent(model_.frames, direction_, step_);
  }

  /// Relative cost error by the model that is at hand: the chain, or the quasi-Newton one.
  double error_estimate() {
    if (chain_) return model_.cost_error;
    const double scale = energy_.scale(path_);
    return scale > 0 ? -slope_ / (2 * scale) : std::numeric_limits<double>::infinity();
  }

  double tolerance() const {
    return kinked_ ? std::max(kKinkedTolerance, loop_.limits().tolerance) : loop_.limits().tolerance;
  }

  /// The stopping test proper: with the exact Hessian where there is one. It is asked again only when the cheap
  /// estimate has fallen by ten since it last said no.
  bool confirmed() {
    const bool smooth = energy_.has_exact_hessian();
    if (chain_ && (!smooth || model_.spacing_error > kSpacingTolerance)) return !smooth;
    if (error_estimate() > 0.1 * refused_) return false;
    ChainModel model = model_;
    model.solve(energy_, path_, HessianKind::exact);
    const bool right_model = !smooth || (model.exact && model.spacing_error <= kSpacingTolerance);
    if (right_model && model.cost_error <= loop_.limits().tolerance) {
      loop_.set_cost_error(model.cost_error);
      return true;
    }
    refused_ = error_estimate();
    return false;
  }

  /// Weak Wolfe by bisection, which needs no differentiability (Lewis, Overton). Where the predicted decrease drowns in
  /// rounding the slopes alone decide.
  bool search() {
    const double slack = rounding_slack(model_.value, path_.segment_count());
    double low = 0, high = std::numeric_limits<double>::infinity(), t = 1;
    bool have_low = false;
    for (int trial = 0; trial < (kinked_ ? kMaxKinkedTrials : kMaxTrials); ++trial) {
      trial_step_ = t * step_;
      energy_.retract(path_, trial_step_, trial_);
      const bool finite = next_.evaluate(energy_, trial_);
      if (!finite || next_.value > model_.value + kArmijo * t * slope_ + slack) {
        high = t;
      } else {
        const double slope = slope_at_trial();
        if (slope >= kCurvature * slope_) return accept();
        low = t;
        have_low = true;
        std::swap(best_, trial_);  // a decrease at least; kept in case no point satisfies both conditions
        std::swap(best_model_, next_);
        best_step_ = trial_step_;
      }
      t = std::isfinite(high) ? 0.5 * (low + high) : 2 * low;
      if (std::isfinite(high) && high - low <= 1e-12 * high) break;
    }
    if (!have_low) return false;
    std::swap(best_, trial_);
    std::swap(best_model_, next_);
    trial_step_ = best_step_;
    return accept();
  }

  /// Slope along the retraction at the trial point: the direction, transported by projection.
  double slope_at_trial() {
    energy_.to_tangent(next_.frames, step_, transported_);
    return next_.tangent.dot(transported_);
  }

  bool accept() {
    largest_move_ = trial_step_.colwise().norm().maxCoeff();
    if (!(next_.value < model_.value) && largest_move_ == 0) return false;
    // s and y live in the new tangent spaces: transport the step and the old gradient there.
    energy_.to_tangent(next_.frames, trial_step_, transported_);
    energy_.from_tangent(next_.frames, transported_, s_);
    energy_.from_tangent(model_.frames, model_.tangent, old_gradient_);
    energy_.to_tangent(next_.frames, old_gradient_, transported_);
    transported_ = next_.tangent - transported_;
    energy_.from_tangent(next_.frames, transported_, y_);
    history_.push(s_, y_);
    // Rounding alone cannot be told from progress for ever.
    stalled_ = next_.value < model_.value ? 0 : stalled_ + 1;
    std::swap(path_, trial_);
    std::swap(model_, next_);
    return stalled_ < 3;
  }

  SolveReport stuck_report() {
    model_.solve(energy_, path_, HessianKind::exact);
    loop_.set_cost_error(model_.cost_error);
    if ((model_.exact || !energy_.has_exact_hessian()) && model_.cost_error <= loop_.limits().tolerance)
      return loop_.finish(Termination::converged, "", model_.value);
    if (model_.decrement / 2 <= 10 * rounding_slack(model_.value, path_.segment_count()))
      return loop_.finish(Termination::round_off, "no decrease above rounding", model_.value);
    return loop_.finish(Termination::line_search_failed, "no step along the search direction lowers the energy",
                        model_.value);
  }

  PathEnergy& energy_;
  CoordinatePath& path_;
  bool chain_, kinked_;
  LbfgsHistory history_;
  SolveLoop loop_;
  ChainModel model_, next_, best_model_;
  CoordinatePath trial_, best_;
  Points step_, trial_step_, best_step_, s_, y_, old_gradient_;
  Eigen::VectorXd direction_, transported_;
  double slope_ = 0, largest_move_ = 0;
  double refused_ = std::numeric_limits<double>::infinity();
  int stalled_ = 0;
};

}  // namespace

void LbfgsOptions::fields(FieldVisitor& visit) {
  tolerance_field(visit, tolerance);
  limit_fields(visit, max_iterations, max_evaluations);
  visit.field("memory", memory, {.help = "Number of stored pairs.", .minimum = 1, .maximum = 1000});
  visit.choice("precondition", precondition,
               {.help = "Initial inverse Hessian. chain: that of the chain (iterations independent of n). none: a "
                        "multiple of the identity."});
}

Lbfgs::Lbfgs(LbfgsOptions options) : options_(checked(options)) {}

SolveReport Lbfgs::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  return LbfgsSolve(energy, path, options_, monitor).run();
}

}  // namespace leastcost
