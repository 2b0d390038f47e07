// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/rounds.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "framework/newton/bundle.hpp"
#include "solvers/limit_fields.hpp"
#include "solvers/stopping_test.hpp"

namespace leastcost {
namespace {

constexpr double kMostTurned = 0.5;     ///< cosine of 60 degrees
constexpr double kFloor = 10;           ///< rounding slacks left to gain when rounding has ended a solve
constexpr double kPlainFloor = 1e4;     ///< the same where a step gains less than that by the condition number
constexpr double kShortestPart = 1e-3;  ///< of a step of the chain's model
constexpr double kTiny = std::numeric_limits<double>::min();
constexpr int kPatience = 2;  ///< rounds in a row without a lower energy
constexpr int kIdle = 100;    ///< evaluations in a row without one, for one direction; then the round is over

class Rounds final : public RoundObjective {
 public:
  Rounds(PathEnergy& energy, CoordinatePath& path, const RoundOptions& options, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        chain_(options.precondition == Preconditioner::chain),
        restart_(options.restart),
        kinked_(energy.problem().manifold->shape() == Shape::polyhedral),
        variables_(energy, options.precondition),
        test_(options.tolerance),
        loop_(energy, path, {options.tolerance, std::numeric_limits<int>::max(), options.max_evaluations}, monitor) {}

  SolveReport run(RoundMinimiser& minimiser) {
    for (int idle = 0;;) {
      if (!variables_.centre(path_)) return no_centre();
      last_centre_ = path_;
      best_value_ = variables_.model().value;
      variables_.pull_back(Eigen::VectorXd::Zero(size()), variables_.model().gradient, slope_);
      if (loop_.iterations() == 0) loop_.record(best_value_, variables_.model().cost_error, 0);
      if (stationary()) return finish(Termination::converged);
      if (const std::optional<Termination> end = loop_.must_end(path_)) return finish(*end);
      const double before = best_value_;
      run_round(minimiser);
      if (bound_met_ && !end_ && !thrown_ && before - best_value_ < kKinkedGain * variables_.model().decrement / 2)
        step_along_bounds();
      if (thrown_) std::rethrow_exception(thrown_);
      if (end_) return finish(*end_);
      if (kinked_ && !(before - best_value_ > kKinkedGain * variables_.model().decrement / 2))
        return descend_by_bundles(energy_, path_, loop_);
      idle = before - best_value_ > rounding_slack(before, path_.segment_count()) ? 0 : idle + 1;
      if (idle == kPatience) return stuck();
    }
  }

  Index size() const override { return variables_.size(); }
  double typical_step() const override {
    const ChainModel& model = variables_.model();
    // With the chain z is -L^-1 g at the minimum of the model, of squared length g' H^-1 g.
    const double size = chain_ ? std::sqrt(model.decrement) : model.step.norm() / variables_.scale();
    const double step = size / std::sqrt(static_cast<double>(model.step.size()));
    return step > 0 && std::isfinite(step) ? step : 1;
  }
  int evaluations_left() const override { return chain_ ? restart_ - evaluations_ : std::numeric_limits<int>::max(); }
  bool must_stop() const override { return stop_; }

  double finite_excess(const Eigen::VectorXd& z, Eigen::VectorXd* gradient) const override {
    const double predicted = std::abs(slope_.dot(z)) + rounding_slack(variables_.model().value, path_.segment_count());
    if (gradient != nullptr) *gradient = 4 * predicted / std::max(z.squaredNorm(), kTiny) * z;
    return variables_.model().value + 2 * predicted;
  }

  double operator()(const Eigen::VectorXd& z, Eigen::VectorXd* gradient) override {
    try {
      return evaluate(z, gradient);
    } catch (...) {
      thrown_ = std::current_exception();
      stop_ = true;
      if (gradient != nullptr) gradient->setZero(size());
      return std::numeric_limits<double>::infinity();
    }
  }

 private:
  /// One round: the back end from z = 0, then the best path it has seen.
  void run_round(RoundMinimiser& minimiser) {
    stop_ = false;
    bound_met_ = false;
    evaluations_ = improved_ = 0;
    best_path_ = path_;
    try {
      words_ = minimiser.minimise(*this);
    } catch (const std::exception& error) {
      words_ = error.what();
    }
    path_ = best_path_;
  }

  /// A round whose trials bounds have stopped may gain next to nothing, again and again. One step of the chain's model,
  /// cut off at the bounds and shortened until it gains, finds those that hold the next round.
  void step_along_bounds() {
    const Points& moves = variables_.model().moves;
    for (double part = 1; part > kShortestPart; part /= 2) {
      energy_.retract(last_centre_, part * moves, trial_);
      const double value = energy_.value_and_gradient(trial_, path_gradient_);
      if (!(value < best_value_)) continue;
      take(value);
      path_ = best_path_;
      return;
    }
  }

  double evaluate(const Eigen::VectorXd& z, Eigen::VectorXd* gradient) {
    if (!z.allFinite()) stop_ = true;  // the back end has lost its way
    if (stop_) {
      if (gradient != nullptr) gradient->setZero(size());
      return std::numeric_limits<double>::infinity();
    }
    ++evaluations_;
    const double value = at(z, gradient);
    if (!end_) end_ = loop_.must_end(path_);
    if (end_ || (chain_ && evaluations_ >= restart_)) stop_ = true;
    if (evaluations_ - improved_ > (gradient != nullptr ? kIdle : kIdle * (1 + static_cast<int>(size())))) stop_ = true;
    if (!chain_ && test_.due(evaluations_) && worth_testing()) stop_ = true;
    return value;
  }

  double at(const Eigen::VectorXd& z, Eigen::VectorXd* gradient) {
    if (!variables_.path_at(z, trial_)) {
      bound_met_ = true;
      // Beyond a bound there is no x(z); but the path that stops at the bound may be the better centre of the next
      // round, with the bound in it.
      const double clamped = energy_.value_and_gradient(trial_, path_gradient_);  // infinite for a bead at rest, say
      if (clamped < best_value_) take(clamped);
      if (gradient != nullptr) gradient->setZero(size());
      return std::numeric_limits<double>::infinity();
    }
    const double value =
        gradient != nullptr ? energy_.value_and_gradient(trial_, path_gradient_) : energy_.value(trial_);
    if (gradient != nullptr) variables_.pull_back(z, path_gradient_, *gradient);
    if (value < best_value_) {
      stop_ = variables_.turned(trial_) < kMostTurned;
      take(value);
    }
    return value;
  }

  void take(double value) {
    const double move = (trial_.u - best_path_.u).colwise().norm().maxCoeff();
    if (best_value_ - value > rounding_slack(value, path_.segment_count())) improved_ = evaluations_;
    best_value_ = value;
    std::swap(best_path_, trial_);
    loop_.record(value, std::numeric_limits<double>::quiet_NaN(), move);
  }

  /// Without restarts the stopping test is asked for in the midst of a round, and ends it.
  bool worth_testing() {
    ChainModel model;
    return model.evaluate(energy_, best_path_) && test_.holds(energy_, best_path_, model, evaluations_);
  }

  bool stationary() {
    const bool holds = test_.holds(energy_, path_, variables_.model(), 0);
    loop_.set_cost_error(test_.cost_error());
    return holds;
  }

  /// A path of finite energy whose gradient is not: no round can begin there. The one before was better than that.
  SolveReport no_centre() {
    if (last_centre_.u.size() == 0)
      return loop_.finish(Termination::non_finite, "the gradient is not finite", energy_.value(path_));
    path_ = last_centre_;
    words_ = "the search reached a point where the gradient is not finite";
    return finish(Termination::line_search_failed);
  }

  SolveReport finish(Termination end) {
    loop_.set_cost_error(measured_cost_error(energy_, path_));
    return loop_.finish(end, words_, energy_.value(path_));
  }

  SolveReport stuck() {
    const double gain = variables_.model().decrement / 2;  // that is left, by the chain's model
    if (gain <= (chain_ ? kFloor : kPlainFloor) * rounding_slack(best_value_, path_.segment_count()))
      return finish(Termination::round_off);
    if (words_.empty()) words_ = "two rounds in a row did not lower the energy";
    return finish(Termination::line_search_failed);
  }

  PathEnergy& energy_;
  CoordinatePath& path_;
  bool chain_;
  int restart_;
  bool kinked_;
  ChainVariables variables_;
  StoppingTest test_;
  SolveLoop loop_;
  CoordinatePath best_path_, last_centre_, trial_;
  Points path_gradient_;
  Eigen::VectorXd slope_;  ///< the gradient at z = 0
  double best_value_ = 0;
  int evaluations_ = 0;  ///< of this round
  int improved_ = 0;     ///< the last of them that lowered the energy by more than rounding
  bool stop_ = false, bound_met_ = false;
  std::optional<Termination> end_;
  std::exception_ptr thrown_;
  std::string words_;
};

}  // namespace

void RoundOptions::fields(FieldVisitor& visit) {
  tolerance_field(visit, tolerance);
  visit.field("max_evaluations", max_evaluations, {.help = "Limit on energy and gradient evaluations.", .minimum = 1});
  visit.choice("precondition", precondition,
               {.help = "chain: variables in which the energy is about |z|^2 / 2, from the chain Hessian (evaluations "
                        "independent of n). none: plain tangent coordinates."});
  visit.field("restart", restart,
              {.help = "Evaluations after which the chain Hessian is factored again and the back end restarted; 15 to "
                       "30 work well. Not used with precondition: none.",
               .minimum = 2});
}

SolveReport solve_by_rounds(PathEnergy& energy, CoordinatePath& path, const RoundOptions& options,
                            RoundMinimiser& minimiser, const Monitor& monitor) {
  return Rounds(energy, path, options, monitor).run(minimiser);
}

}  // namespace leastcost
