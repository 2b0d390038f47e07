// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A cost and a solver of one's own, with their options.
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/energy/stopping.hpp>

namespace own {

using namespace leastcost;

/// Travel time of a ray through a medium whose speed is 1 + gain * depth.
struct RayTime {
  static constexpr int dim = 2;
  static constexpr bool encloses = true;  // compile it with intervals, too: certificates can be proved
  double gain;
  CostTraits traits() const { return {.unit = "s", .symmetric = true}; }

  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const S speed = 1.0 + 0.5 * gain * (a[1] + b[1]);
    if (!(speed > S(0.0))) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() / (speed * speed);
  }
};

struct RayTimeOptions {
  double gain = 0.5;
  void fields(FieldVisitor& visit) {
    visit.field("gain", gain, {.help = "Growth of the speed with depth.", .unit = "1/s", .minimum = 0});
  }
};

struct GaussNewtonOptions {
  Limits limits = {.tolerance = 1e-14, .max_iterations = 200};
  void fields(FieldVisitor& visit) {
    visit.field("tolerance", limits.tolerance,
                {.help = "Stop at this relative error of the cost.", .minimum = 0, .exclusive_minimum = true});
    visit.field("max_iterations", limits.max_iterations, {.help = "Limit on iterations.", .minimum = 0});
    visit.field("max_evaluations", limits.max_evaluations, {.help = "Limit on evaluations.", .minimum = 1});
  }
};

/// Gauss-Newton steps on the chain, halved until the energy falls.
class GaussNewton final : public Solver {
 public:
  explicit GaussNewton(const GaussNewtonOptions& options = {}) : limits_(options.limits) {}
  std::string_view name() const override { return "gauss_newton"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override {
    SolveLoop loop(energy, path, limits_, monitor);
    CoordinatePath trial;
    Points gradient, step;
    Frames frames;
    ChainSystem hessian;
    Eigen::VectorXd slope, newton;
    double longest = 0;
    for (;;) {
      const double value = energy.value_and_gradient(path, gradient);
      energy.frames(path, gradient, frames);
      energy.to_tangent(frames, gradient, slope);
      energy.chain_hessian(path, gradient, frames, HessianKind::gauss_newton, hessian);
      if (!energy.factor(hessian)) return loop.finish(Termination::round_off, "the Hessian is not definite", value);
      newton = slope;
      energy.solve(hessian, newton);
      const double cost_error = slope.dot(newton) / (2 * energy.scale(path));
      loop.record(value, cost_error, longest);
      if (cost_error <= loop.limits().tolerance) return loop.finish(Termination::converged, "", value);
      if (const std::optional<Termination> end = loop.must_end(path)) return loop.finish(*end, "", value);
      for (double t = 1;; t /= 2) {
        if (t < 1e-10) return loop.finish(Termination::line_search_failed, "no step lowers the energy", value);
        energy.from_tangent(frames, -t * newton, step);
        energy.retract(path, step, trial);
        if (energy.value(trial) < value) break;
      }
      longest = step.colwise().norm().maxCoeff();
      std::swap(path, trial);
    }
  }

  Limits limits_;
};

}  // namespace own
