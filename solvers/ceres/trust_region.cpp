// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/ceres/trust_region.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "framework/newton/bundle.hpp"
#include "solvers/ceres/chain_residuals.hpp"
#include "solvers/ceres/point_manifold.hpp"
#include "solvers/ceres/silence.hpp"
#include "solvers/stopping_test.hpp"

namespace leastcost {
namespace {

/// H as a loss of the squared residual: rho(q) = 2 phi(q / s0^2), because Ceres minimises half the sum of the losses.
class KernelLoss final : public ceres::LossFunction {
 public:
  KernelLoss(const Kernel& kernel, double s0) : kernel_(kernel), scale_(1 / (s0 * s0)) {}
  void Evaluate(double q, double rho[3]) const override {
    const double argument = q * scale_;
    Jet2 phi;
    kernel_.apply({&argument, 1}, {&phi, 1});
    rho[0] = 2 * phi.value;
    rho[1] = 2 * phi.d1 * scale_;
    rho[2] = 2 * phi.d2 * scale_ * scale_;
  }

 private:
  const Kernel& kernel_;
  double scale_;
};

/// Ceres from one path on, round by round: within a round the blocked directions are those of its first path. Without
/// bounds there is one round.
class TrustRegion final : public ceres::IterationCallback {
 public:
  TrustRegion(PathEnergy& energy, CoordinatePath& path, ceres::TrustRegionStrategyType strategy,
              const RoundOptions& rounds, int max_iterations, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        strategy_(strategy),
        max_iterations_(max_iterations),
        kinked_(energy.problem().manifold->shape() == Shape::polyhedral),
        bounded_(find_ability<HasBounds>(*energy.problem().manifold) != nullptr),
        loss_(*energy.problem().kernel, energy.reference_cost()),
        test_(rounds.tolerance),
        loop_(energy, path, {rounds.tolerance, max_iterations, rounds.max_evaluations}, monitor) {}

  SolveReport run() {
    for (int idle = 0; idle < kPatience;) {
      if (!model_.evaluate(energy_, path_))
        return loop_.finish(Termination::non_finite, "the gradient is not finite", model_.value);
      best_value_ = model_.value;
      run_round();
      if (end_ || kinked_ || !bounded_) break;
      idle = model_.value - best_value_ > rounding_slack(model_.value, path_.segment_count()) ? 0 : idle + 1;
    }
    return finish();
  }

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    try {
      return look(summary);
    } catch (...) {
      thrown_ = std::current_exception();
      return ceres::SOLVER_ABORT;
    }
  }

 private:
  static constexpr double kMayBeDone = 1e-9;        ///< relative gain of a step
  static constexpr double kSecondsPerPoint = 5e-6;  ///< to set a round up, with its first iteration
  static constexpr double kAfterDeadline = 1e-3;    ///< seconds that an iteration may last beyond the deadline
  static constexpr int kPatience = 2;               ///< rounds in a row without a lower energy

  /// Ceres cannot be stopped in the midst of an iteration: none is begun that would end long after the deadline.
  bool too_late_for(double seconds) const {
    const auto& end = energy_.deadline().time();
    if (!end) return false;
    return std::chrono::duration<double>(*end - Monitor::Clock::now()).count() + kAfterDeadline < seconds;
  }

  void run_round() {
    longest_ = kSecondsPerPoint * static_cast<double>(path_.u.cols());
    if (too_late_for(longest_)) {
      end_ = Termination::time_limit;
      return;
    }
    ChainResiduals residuals(energy_, path_);
    residuals_ = &residuals;
    residuals.evaluate(true);
    if (!residuals.thrown()) solve(residuals);
    if (thrown_) std::rethrow_exception(thrown_);
    if (residuals.thrown()) std::rethrow_exception(residuals.thrown());
    if (residuals.stopped_energy() < best_value_) {
      best_value_ = residuals.stopped_energy();
      path_ = residuals.stopped_path();
    }
  }

  void solve(ChainResiduals& residuals) {
    ceres::Problem problem = build(residuals);
    ceres::Solver::Options options;
    options.minimizer_type = ceres::TRUST_REGION;
    options.trust_region_strategy_type = strategy_;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = max_iterations_;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0;
    options.max_num_consecutive_invalid_steps = 50;
    options.logging_type = ceres::SILENT;
    options.update_state_every_iteration = true;
    options.callbacks.push_back(this);
    ceres::Solver::Summary summary;
    const Silence silence;
    ceres::Solve(options, &problem, &summary);
    energy_.count({.linear_solves = summary.num_linear_solves});
    words_ = "ceres: " + summary.message;
  }

  ceres::Problem build(ChainResiduals& residuals) {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.evaluation_callback = &residuals;
    ceres::Problem problem(options);
    const int k = energy_.problem().manifold->dimensions().coordinate;
    const Index columns = path_.u.cols(), first = path_.free_begin();
    for (Index i = 0; i < columns; ++i) {
      const bool free = path_.ring || (i > 0 && i + 1 < columns);
      add_point(problem, residuals, i, free ? i - first : -1);
    }
    // The segment of a ring of one point joins it to itself: it is always zero, and Ceres would abort at it.
    for (Index i = 0; columns > 1 && i < path_.segment_count(); ++i)
      problem.AddResidualBlock(new SegmentResiduals(residuals, i, k), &loss_, residuals.point(i),
                               residuals.point((i + 1) % columns));
    return problem;
  }

  /// free_index: the point's number among the free ones; -1: an end.
  void add_point(ceres::Problem& problem, ChainResiduals& residuals, Index column, Index free_index) {
    const Dimensions dims = energy_.problem().manifold->dimensions();
    const Frames& frames = model_.frames;
    const int blocked = free_index < 0 || frames.identity ? 0 : frames.blocked[static_cast<std::size_t>(free_index)];
    Points free(dims.coordinate, 0);
    if (blocked > 0) free = frames.bases.middleCols(dims.tangent * free_index, dims.tangent - blocked);
    problem.AddParameterBlock(
        residuals.point(column), dims.coordinate,
        new PointManifold(*energy_.problem().manifold, std::move(free), residuals.stopped(), energy_.deadline()));
    if (free_index < 0 || blocked == dims.tangent) problem.SetParameterBlockConstant(residuals.point(column));
  }

  ceres::CallbackReturnType look(const ceres::IterationSummary& summary) {
    residuals_->stopped() = false;  // of the step -gradient, which Ceres only measures: the next one is another
    if (summary.step_is_successful) keep(summary.cost);
    double cost_error = std::numeric_limits<double>::quiet_NaN();
    // The test has its price, and says no while a step still gains much.
    if (summary.iteration == 0 || summary.cost_change <= kMayBeDone * summary.cost) {
      ChainModel model;
      if (model.evaluate(energy_, path_) && test_.holds(energy_, path_, model, 0)) end_ = Termination::converged;
      cost_error = test_.cost_error();
    }
    loop_.record(best_value_, cost_error, summary.step_norm);
    if (!end_) end_ = loop_.must_end(path_);
    longest_ = std::max(longest_, summary.iteration_time_in_seconds);  // the first is an evaluation only
    if (!end_ && too_late_for(longest_)) end_ = Termination::time_limit;
    return end_ || residuals_->stopped_energy() < best_value_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                              : ceres::SOLVER_CONTINUE;
  }

  /// The cost that Ceres speaks of is our energy, except where a point has left the polyhedron.
  void keep(double value) {
    CoordinatePath now = residuals_->path();
    if (kinked_) {
      energy_.problem().manifold->project(now);
      if (!now.ring) now.u.col(0) = path_.u.col(0), now.u.rightCols(1) = path_.u.rightCols(1);
      value = energy_.value(now);
    }
    if (!(value <= best_value_)) return;
    best_value_ = value;
    path_ = std::move(now);
  }

  SolveReport finish() {
    best_value_ = energy_.value(path_);  // summed in our order
    if (end_ == Termination::converged) return loop_.finish(*end_, "", best_value_);
    if (!end_ && kinked_) return descend_by_bundles(energy_, path_, loop_);
    const double error = measured_cost_error(energy_, path_);
    loop_.set_cost_error(error);
    if (end_) return loop_.finish(*end_, "", best_value_);
    const bool at_floor = error * energy_.scale(path_) <= 10 * rounding_slack(best_value_, path_.segment_count());
    return loop_.finish(at_floor ? Termination::round_off : Termination::line_search_failed, words_, best_value_);
  }

  PathEnergy& energy_;
  CoordinatePath& path_;
  ceres::TrustRegionStrategyType strategy_;
  int max_iterations_;
  bool kinked_, bounded_;
  KernelLoss loss_;
  StoppingTest test_;
  SolveLoop loop_;
  ChainModel model_;                     ///< at the first path of the round
  ChainResiduals* residuals_ = nullptr;  ///< of the round
  double best_value_ = 0;
  double longest_ = 0;  ///< seconds of an iteration of the round, as expected or measured
  std::optional<Termination> end_;
  std::exception_ptr thrown_;
  std::string words_;
};

}  // namespace

SolveReport solve_by_trust_region(PathEnergy& energy, CoordinatePath& path, ceres::TrustRegionStrategyType strategy,
                                  const RoundOptions& rounds, int max_iterations, const Monitor& monitor) {
  return TrustRegion(energy, path, strategy, rounds, max_iterations, monitor).run();
}

}  // namespace leastcost
