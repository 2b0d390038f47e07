// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/ceres/trust_region.hpp"

#include <ceres/ceres.h>

#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "framework/bundle.hpp"
#include "solvers/rare_test.hpp"

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

/// One point on the domain: its tangent frame and retraction, on a path of one column.
class PointManifold final : public ceres::Manifold {
 public:
  explicit PointManifold(const ConstraintManifold& manifold) : manifold_(manifold), dims_(manifold.dimensions()) {}
  int AmbientSize() const override { return dims_.coordinate; }
  int TangentSize() const override { return dims_.tangent; }

  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    CoordinatePath from = at(x), to;
    const Points step = basis(from) * Eigen::Map<const Eigen::VectorXd>(delta, dims_.tangent);
    if (!step.allFinite()) return false;
    manifold_.retract(from, step, to);
    Eigen::Map<Eigen::VectorXd>(x_plus_delta, dims_.coordinate) = to.u.col(0);
    return to.u.allFinite();
  }
  bool PlusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(jacobian, dims_.coordinate,
                                                                                       dims_.tangent) = basis(at(x));
    return true;
  }
  bool Minus(const double* y, const double* x, double* y_minus_x) const override {
    const Eigen::Map<const Eigen::VectorXd> to(y, dims_.coordinate), from(x, dims_.coordinate);
    Eigen::Map<Eigen::VectorXd>(y_minus_x, dims_.tangent) = basis(at(x)).transpose() * (to - from);
    return true;
  }
  bool MinusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        jacobian, dims_.tangent, dims_.coordinate) = basis(at(x)).transpose();
    return true;
  }

 private:
  /// A ring of one column: a path all of whose points are free.
  CoordinatePath at(const double* x) const {
    CoordinatePath one{Eigen::Map<const Eigen::VectorXd>(x, dims_.coordinate), {}, true};
    if (manifold_.shape() == Shape::polyhedral) manifold_.project(one);  // finds its site
    return one;
  }
  Points basis(const CoordinatePath& one) const {
    Points out;
    manifold_.tangent_bases(one, out);
    return out;
  }

  const ConstraintManifold& manifold_;
  Dimensions dims_;
};

/// The path whose columns Ceres moves, with residuals computed once for all segments.
class Residuals final : public ceres::EvaluationCallback {
 public:
  Residuals(PathEnergy& energy, const CoordinatePath& path) : energy_(energy), path_(path) {}
  double* point(Index column) { return path_.u.col(column).data(); }
  const CoordinatePath& path() const { return path_; }
  std::exception_ptr thrown() const { return thrown_; }
  bool usable() const { return usable_; }
  Index rows() const { return r_.rows(); }
  const Points& values() const { return r_; }
  const Points& jacobians() const { return jacobians_; }

  void PrepareForEvaluation(bool with_jacobians, bool new_point) override {
    if (!new_point && (!with_jacobians || have_jacobians_)) return;
    evaluate(with_jacobians);
  }
  /// Whether the cost has a residual form that is finite here.
  bool evaluate(bool with_jacobians) {
    usable_ = false;
    have_jacobians_ = with_jacobians;
    try {
      usable_ = energy_.residuals(path_, r_, with_jacobians ? &jacobians_ : nullptr) && r_.allFinite() &&
                (!with_jacobians || jacobians_.allFinite());
    } catch (...) {
      thrown_ = std::current_exception();
    }
    return usable_;
  }

 private:
  PathEnergy& energy_;
  CoordinatePath path_;
  Points r_, jacobians_;
  bool usable_ = false, have_jacobians_ = false;
  std::exception_ptr thrown_;
};

/// The residual of one segment, read from the common evaluation.
class SegmentResiduals final : public ceres::CostFunction {
 public:
  SegmentResiduals(const Residuals& all, Index segment, int coordinates)
      : all_(all), segment_(segment), k_(coordinates) {
    set_num_residuals(static_cast<int>(all.rows()));
    *mutable_parameter_block_sizes() = {coordinates, coordinates};
  }
  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    if (!all_.usable()) return false;
    const Index rows = all_.rows();
    Eigen::Map<Eigen::VectorXd>(residuals, rows) = all_.values().col(segment_);
    if (jacobians == nullptr) return true;
    for (int end = 0; end < 2; ++end)
      if (jacobians[end] != nullptr)
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(jacobians[end], rows, k_) =
            all_.jacobians().middleCols(2 * k_ * segment_ + k_ * end, k_);
    return true;
  }

 private:
  const Residuals& all_;
  Index segment_;
  int k_;
};

class TrustRegion final : public ceres::IterationCallback {
 public:
  TrustRegion(PathEnergy& energy, CoordinatePath& path, const CeresOptions& options, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        options_(options),
        kinked_(energy.problem().manifold->shape() == Shape::polyhedral),
        manifold_(*energy.problem().manifold),
        loss_(*energy.problem().kernel, energy.reference_cost()),
        residuals_(energy, path),
        test_(options.rounds.tolerance),
        loop_(energy, path, {options.rounds.tolerance, options.max_iterations, options.rounds.max_evaluations},
              monitor) {}

  SolveReport run() {
    best_value_ = energy_.value(path_);
    if (!residuals_.evaluate(true))
      return loop_.finish(Termination::non_finite, "the residuals of the first path are not finite", best_value_);
    ceres::Problem problem = build();
    ceres::Solver::Options options;
    options.minimizer_type = ceres::TRUST_REGION;
    options.trust_region_strategy_type = options_.algorithm == "dogleg" ? ceres::DOGLEG : ceres::LEVENBERG_MARQUARDT;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = options_.max_iterations;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0;
    options.max_num_consecutive_invalid_steps = 50;
    options.logging_type = ceres::SILENT;
    options.update_state_every_iteration = true;
    options.callbacks.push_back(this);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (thrown_) std::rethrow_exception(thrown_);
    if (residuals_.thrown()) std::rethrow_exception(residuals_.thrown());
    return finish("ceres: " + summary.message);
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
  ceres::Problem build() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::TAKE_OWNERSHIP;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.evaluation_callback = &residuals_;
    ceres::Problem problem(options);
    const int k = energy_.problem().manifold->dimensions().coordinate;
    const Index columns = path_.u.cols();
    for (Index i = 0; i < columns; ++i) problem.AddParameterBlock(residuals_.point(i), k, &manifold_);
    if (!path_.ring) {
      problem.SetParameterBlockConstant(residuals_.point(0));
      problem.SetParameterBlockConstant(residuals_.point(columns - 1));
    }
    for (Index i = 0; i < path_.segment_count(); ++i)
      problem.AddResidualBlock(new SegmentResiduals(residuals_, i, k), &loss_, residuals_.point(i),
                               residuals_.point((i + 1) % columns));
    return problem;
  }

  ceres::CallbackReturnType look(const ceres::IterationSummary& summary) {
    if (summary.step_is_successful || summary.iteration == 0) {
      CoordinatePath now = residuals_.path();
      if (kinked_) energy_.problem().manifold->project(now);
      const double value = energy_.value(now);
      if (value <= best_value_) {
        best_value_ = value;
        path_ = std::move(now);
      }
    }
    ChainModel model;
    if (model.evaluate(energy_, path_) && test_.holds(energy_, path_, model, 0)) end_ = Termination::converged;
    loop_.record(best_value_, test_.cost_error(), summary.step_norm);
    if (!end_) end_ = loop_.must_end(path_);
    return end_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

  SolveReport finish(const std::string& words) {
    if (end_ && *end_ != Termination::converged) return loop_.finish(*end_, "", best_value_);
    if (end_) return loop_.finish(*end_, "", best_value_);
    if (kinked_) return descend_by_bundles(energy_, path_, loop_);
    const double error = measured_cost_error(energy_, path_);
    loop_.set_cost_error(error);
    const bool at_floor = error * energy_.scale(path_) <= 10 * rounding_slack(best_value_, path_.segment_count());
    return loop_.finish(at_floor ? Termination::round_off : Termination::line_search_failed, words, best_value_);
  }

  PathEnergy& energy_;
  CoordinatePath& path_;
  const CeresOptions& options_;
  bool kinked_;
  PointManifold manifold_;
  KernelLoss loss_;
  Residuals residuals_;
  RareTest test_;
  SolveLoop loop_;
  double best_value_ = 0;
  std::optional<Termination> end_;
  std::exception_ptr thrown_;
};

}  // namespace

SolveReport solve_by_trust_region(PathEnergy& energy, CoordinatePath& path, const CeresOptions& options,
                                  const Monitor& monitor) {
  return TrustRegion(energy, path, options, monitor).run();
}

}  // namespace leastcost
