// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/gradient_descent.hpp>

#include <utility>

#include <leastcost/framework/energy/stopping.hpp>
#include "framework/newton/bundle.hpp"
#include "solvers/first_move.hpp"
#include "solvers/limit_fields.hpp"
#include "solvers/stopping_test.hpp"

namespace leastcost {
namespace {

constexpr int kDescentHalvings = 60;

class Descent {
 public:
  Descent(PathEnergy& energy, CoordinatePath& path, const GradientDescentOptions& options, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        kinked_(energy.problem().manifold->shape() == Shape::polyhedral),
        test_(options.tolerance),
        loop_(energy, path, {options.tolerance, options.max_iterations, options.max_evaluations}, monitor) {}

  SolveReport run() {
    if (!model_.evaluate(energy_, path_))
      return loop_.finish(Termination::non_finite, "the gradient is not finite", model_.value);
    const double longest = steps(1).colwise().norm().maxCoeff();
    step_ = longest > 0 ? kFirstMove * mean_segment(path_) / longest : 1;
    for (int i = 0;; ++i) {
      const bool stationary = test_.due(i) && test_.holds(energy_, path_, model_, i);
      loop_.record(model_.value, test_.cost_error(), largest_move_);
      if (stationary) return loop_.finish(Termination::converged, "", model_.value);
      if (const std::optional<Termination> end = loop_.must_end(path_)) return finish(*end);
      const double before = model_.value, predicted = step_ * model_.tangent.squaredNorm() / 2;
      const bool moved = search();
      if (kinked_ && !(before - model_.value > kKinkedGain * predicted))
        return descend_by_bundles(energy_, path_, loop_);
      if (!moved) return stuck_report();
    }
  }

 private:
  /// -t g, in coordinates.
  Points& steps(double t) {
    direction_ = -t * model_.tangent;
    energy_.from_tangent(model_.frames, direction_, move_);
    return move_;
  }

  bool search() {
    const double slope = model_.tangent.squaredNorm(), slack = rounding_slack(model_.value, path_.segment_count());
    double t = 2 * step_;
    for (int i = 0; i < kDescentHalvings; ++i, t /= 2) {
      energy_.retract(path_, steps(t), trial_);
      if (!(energy_.value(trial_) < model_.value - kArmijo * t * slope + slack)) continue;
      if (!next_.evaluate(energy_, trial_)) continue;
      largest_move_ = move_.colwise().norm().maxCoeff();
      stalled_ = next_.value < model_.value ? 0 : stalled_ + 1;  // rounding cannot be told from progress for ever
      step_ = t;
      std::swap(path_, trial_);
      std::swap(model_, next_);
      return stalled_ < kMostStalled;
    }
    return false;
  }

  SolveReport finish(Termination end) {
    test_.holds(energy_, path_, model_, loop_.iterations());
    loop_.set_cost_error(test_.cost_error());
    return loop_.finish(end, "", model_.value);
  }

  SolveReport stuck_report() {
    const bool stationary = test_.holds(energy_, path_, model_, loop_.iterations());
    loop_.set_cost_error(test_.cost_error());
    if (stationary) return loop_.finish(Termination::converged, "", model_.value);
    if (stalled_ == kMostStalled)
      return loop_.finish(Termination::round_off, "no decrease above rounding", model_.value);
    return loop_.finish(Termination::line_search_failed, "no step against the gradient lowers the energy",
                        model_.value);
  }

  static constexpr int kMostStalled = 3;

  PathEnergy& energy_;
  CoordinatePath& path_;
  bool kinked_;
  StoppingTest test_;
  SolveLoop loop_;
  ChainModel model_, next_;
  CoordinatePath trial_;
  Eigen::VectorXd direction_;
  Points move_;
  double step_ = 1, largest_move_ = 0;
  int stalled_ = 0;
};

}  // namespace

void GradientDescentOptions::fields(FieldVisitor& visit) {
  tolerance_field(visit, tolerance);
  limit_fields(visit, max_iterations, max_evaluations);
}

SolveReport GradientDescent::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  return Descent(energy, path, options_, monitor).run();
}

}  // namespace leastcost
