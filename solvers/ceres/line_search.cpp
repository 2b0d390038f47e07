// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/ceres/line_search.hpp"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <cmath>
#include <limits>
#include <vector>

#include "solvers/ceres/silence.hpp"

namespace leastcost {
namespace {

/// The objective of one round as Ceres wants it.
class Function final : public ceres::FirstOrderFunction {
 public:
  explicit Function(RoundObjective& objective) : objective_(objective) {}
  int NumParameters() const override { return static_cast<int>(objective_.size()); }
  bool Evaluate(const double* z, double* cost, double* gradient) const override {
    if (objective_.must_stop()) return false;
    const Eigen::Map<const Eigen::VectorXd> at(z, objective_.size());
    Eigen::VectorXd g;
    *cost = objective_(at, gradient != nullptr ? &g : nullptr);
    if (!std::isfinite(*cost)) return false;
    if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, g.size()) = g;
    return true;
  }

 private:
  RoundObjective& objective_;
};

class StopWhenTold final : public ceres::IterationCallback {
 public:
  explicit StopWhenTold(const RoundObjective& objective) : objective_(objective) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return objective_.must_stop() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const RoundObjective& objective_;
};

class CeresRounds final : public RoundMinimiser {
 public:
  explicit CeresRounds(ceres::LineSearchDirectionType direction) : direction_(direction) {}

  std::string minimise(RoundObjective& objective) override {
    ceres::GradientProblem problem(new Function(objective));
    StopWhenTold callback(objective);
    ceres::GradientProblemSolver::Options options;
    options.line_search_direction_type = direction_;
    options.max_num_iterations = std::numeric_limits<int>::max();
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0;
    options.logging_type = ceres::SILENT;
    options.callbacks.push_back(&callback);
    std::vector<double> z(static_cast<std::size_t>(objective.size()), 0.0);
    ceres::GradientProblemSolver::Summary summary;
    const Silence silence;
    ceres::Solve(options, problem, z.data(), &summary);
    return "ceres: " + summary.message;
  }

 private:
  ceres::LineSearchDirectionType direction_;
};

}  // namespace

SolveReport solve_by_line_search(PathEnergy& energy, CoordinatePath& path, ceres::LineSearchDirectionType direction,
                                 const RoundOptions& options, const Monitor& monitor) {
  CeresRounds minimiser(direction);
  return solve_by_rounds(energy, path, options, minimiser, monitor);
}

}  // namespace leastcost
