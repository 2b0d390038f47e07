// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A solver of one's own: Gauss-Newton steps on the chain, halved until the energy falls.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include <leastcost/framework/energy/stopping.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/newton.hpp>

namespace {

using namespace leastcost;

class GaussNewton final : public Solver {
 public:
  std::string_view name() const override { return "gauss_newton"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override {
    SolveLoop loop(energy, path, {.tolerance = 1e-14, .max_iterations = 200}, monitor);
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
};

}  // namespace

int main() {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(std::numbers::pi, -2);
  problem.cost = make_travel_time_cost({.gravity = 1}, 2, problem.source.u);
  problem.kernel = make_kernel<Expm1Square>();
  const Newton newton;
  const Result result = find_path(problem, StraightInitializer(), GaussNewton(), {.points = 60});

  std::printf("%d iterations, %.8f s, exact pi\n", result.solve.iterations, result.certificate.estimate.value);
  const bool right = std::abs(result.certificate.estimate.value - std::numbers::pi) < 1e-5;
  return result.certificate.certified() && right ? 0 : 1;
}
