// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/vfcs.hpp>

#include <limits>
#include <sstream>
#include <utility>

#include <leastcost/framework/energy/stopping.hpp>
#include "solvers/first_move.hpp"
#include "solvers/lbfgs_history.hpp"
#include "solvers/limit_fields.hpp"
#include "solvers/stopping_test.hpp"

namespace leastcost {
namespace {

constexpr int kVfcsHalvings = 40;

/// Numbers in comments are the lines of Algorithm 1.
class Algorithm1 {
 public:
  Algorithm1(PathEnergy& energy, CoordinatePath& path, const VfcsOptions& options, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        gradient_tolerance_(options.gradient_tolerance),
        history_(options.memory),
        loop_(energy, path, {0, options.max_iterations, options.max_evaluations}, monitor) {}

  SolveReport run() {
    if (!evaluate(path_, value_, gradient_))  // 2
      return loop_.finish(Termination::non_finite, "the gradient is not finite", value_);
    for (;;) {
      loop_.record(value_, std::numeric_limits<double>::quiet_NaN(), largest_move_);
      if (gradient_.norm() <= gradient_tolerance_) return finish(Termination::fixed_point, rule());  // 3
      if (const std::optional<Termination> end = loop_.must_end(path_)) return finish(*end, "");
      if (!step()) {
        if (history_.empty())
          return finish(Termination::line_search_failed, "no step along the search direction lowers the energy");
        history_.clear();
      }
    }
  }

 private:
  /// E and its projected gradient, back in coordinates.
  bool evaluate(const CoordinatePath& path, double& value, Points& gradient) {
    if (!model_.evaluate(energy_, path)) return false;
    value = model_.value;
    energy_.from_tangent(model_.frames, model_.tangent, gradient);
    return true;
  }

  std::string rule() const {
    std::ostringstream out;
    out.precision(3);
    out << "projected gradient " << gradient_.norm() << " <= " << gradient_tolerance_ << " (VFCS Algorithm 1)";
    return out.str();
  }

  /// 4 to 7.
  bool step() {
    flat_gradient_ = gradient_.reshaped();
    history_.use_as_stored();
    history_.direction(
        flat_gradient_, [](Eigen::VectorXd&) {}, direction_);
    double slope = flat_gradient_.dot(direction_);
    if (!(slope < 0)) return false;
    move_ = direction_.reshaped(gradient_.rows(), gradient_.cols());
    double t = 1;
    if (history_.empty()) t = kFirstMove * mean_segment(path_) / move_.colwise().norm().maxCoeff();
    for (int i = 0; i < kVfcsHalvings; ++i, t /= 2) {
      trial_move_ = t * move_;
      energy_.retract(path_, trial_move_, trial_);
      const double value = energy_.value(trial_);
      if (!(value <= value_ + kArmijo * t * slope + rounding_slack(value_, path_.segment_count()))) continue;
      double next_value = 0;
      if (!evaluate(trial_, next_value, next_gradient_)) continue;
      const Index first = path_.free_begin(), n = path_.free_count();
      if (next_gradient_.norm() >= gradient_.norm() && !(next_value < value_)) continue;  // rounding is no progress
      largest_move_ = trial_move_.colwise().norm().maxCoeff();
      history_.push(trial_.u.middleCols(first, n) - path_.u.middleCols(first, n), next_gradient_ - gradient_);
      std::swap(path_, trial_);
      std::swap(gradient_, next_gradient_);
      value_ = next_value;
      return true;
    }
    return false;
  }

  SolveReport finish(Termination end, std::string message) {
    loop_.set_cost_error(measured_cost_error(energy_, path_));
    return loop_.finish(end, std::move(message), value_);
  }

  PathEnergy& energy_;
  CoordinatePath& path_;
  double gradient_tolerance_;
  LbfgsHistory history_;
  SolveLoop loop_;
  ChainModel model_;
  CoordinatePath trial_;
  Points gradient_, next_gradient_, move_, trial_move_;
  Eigen::VectorXd flat_gradient_, direction_;
  double value_ = 0, largest_move_ = 0;
};

}  // namespace

void VfcsOptions::fields(FieldVisitor& visit) {
  visit.field("gradient_tolerance", gradient_tolerance,
              {.help = "Stops at this norm of the projected gradient: the rule of the paper.", .minimum = 0});
  limit_fields(visit, max_iterations, max_evaluations);
  visit.field("memory", memory, {.help = "Number of stored pairs.", .minimum = 1, .maximum = 1000});
}

SolveReport Vfcs::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  return Algorithm1(energy, path, options_, monitor).run();
}

}  // namespace leastcost
