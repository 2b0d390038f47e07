// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/string_method.hpp>

#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/stopping.hpp>
#include "framework/energy/spacing.hpp"
#include "solvers/best_by_cost.hpp"
#include "solvers/first_move.hpp"
#include "solvers/limit_fields.hpp"

namespace leastcost {
namespace {

class String {
 public:
  String(PathEnergy& energy, CoordinatePath& path, const StringMethodOptions& options, const Monitor& monitor)
      : energy_(energy),
        path_(path),
        options_(options),
        best_(energy, path),
        loop_(energy, path, {options.tolerance, options.max_iterations, options.max_evaluations}, monitor) {}

  SolveReport run() {
    if (!model_.evaluate(energy_, path_))
      return loop_.finish(Termination::non_finite, "the gradient is not finite", model_.value);
    double cost = best_.cost(), moved = 1;
    for (;;) {
      loop_.record(model_.value, std::numeric_limits<double>::quiet_NaN(), largest_move_);
      if (moved <= options_.tolerance) return best_.at_rest(loop_, cost);
      if (const std::optional<Termination> end = loop_.must_end(path_)) return best_.finish(loop_, *end, "");
      if (!step()) return best_.finish(loop_, Termination::non_finite, "a step leaves the domain of the cost");
      moved = largest_move_ / mean_segment(path_);
      cost = best_.consider(path_);
    }
  }

 private:
  /// One step of every point normal to the path, and equal spacing again.
  bool step() {
    energy_.from_tangent(model_.frames, model_.tangent, force_);
    // What a single point feels of the energy's curvature: an explicit step is stable below its inverse.
    energy_.chain_hessian(path_, model_.gradient, model_.frames, HessianKind::gauss_newton, model_.system);
    for (Index i = 0; i < force_.cols(); ++i) {
      const Index at = path_.free_begin() + i;
      const Eigen::VectorXd along = (path_.column(at + 1) - path_.column(at - 1)).normalized();
      force_.col(i) -= along.dot(force_.col(i)) * along;
      force_.col(i) *= -options_.step / model_.system.diagonal(i).cwiseAbs().colwise().sum().maxCoeff();
    }
    energy_.retract(path_, force_, moved_);
    if (!std::isfinite(energy_.value(moved_))) return false;
    const int points = static_cast<int>(path_.free_count());
    MaybeChain sampled = try_sampling(energy_.problem(), moved_, {points, kEven, kPasses});
    if (!sampled) return false;
    CoordinatePath& even = *sampled.chain;
    if (!model_.evaluate(energy_, even)) return false;
    largest_move_ = (even.u - path_.u).colwise().norm().maxCoeff();
    path_ = std::move(even);
    return true;
  }

  static constexpr double kEven = 1e-12;
  static constexpr int kPasses = 3;

  PathEnergy& energy_;
  CoordinatePath path_, moved_;
  StringMethodOptions options_;
  BestByCost best_;
  SolveLoop loop_;
  ChainModel model_;
  Points force_;
  double largest_move_ = 0;
};

}  // namespace

void StringMethodOptions::fields(FieldVisitor& visit) {
  visit.field("step", step,
              {.help = "Step along the force, relative to the largest stable step of the stiffest point.",
               .minimum = 0,
               .maximum = 1,
               .exclusive_minimum = true});
  visit.field("tolerance", tolerance,
              {.help = "Stops when no point moves farther in one iteration.", .unit = "segments", .minimum = 0});
  limit_fields(visit, max_iterations, max_evaluations);
}

SolveReport StringMethod::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  return String(energy, path, options_, monitor).run();
}

}  // namespace leastcost
