// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Iterations and time of the chain solvers against the number of points, and against plain L-BFGS. One run, ratios.
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "framework/cascade.hpp"
#include "framework/path_energy.hpp"
#include "framework/segment_cost_function.hpp"
#include "framework/spacing.hpp"
#include "problems/costs/travel_time.hpp"
#include "problems/initializers/straight.hpp"
#include "problems/kernels/kernels.hpp"
#include "problems/manifolds/euclidean.hpp"
#include "solvers/lbfgs.hpp"
#include "solvers/newton.hpp"

namespace {

using namespace leastcost;

/// Upper half-plane, |b - a| over the height at the middle: a cost as a user would write it.
struct HalfPlane {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "length"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const S y = (a[1] + b[1]) * 0.5;
    if (!(innermost(y) > 0)) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() / (y * y);
  }
};

struct Case {
  const char* name;
  Problem problem;
};

Problem in_plane(Eigen::Vector2d source, Eigen::Vector2d target, std::shared_ptr<const SegmentCost> cost) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{});
  problem.cost = std::move(cost);
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

Problem chute(double start_speed, Eigen::Vector2d target) {
  TravelTimeOptions options;
  options.gravity = 1;
  options.start_speed = start_speed;
  const Eigen::Vector2d source = Eigen::Vector2d::Zero();
  return in_plane(source, target, make_travel_time_cost(options, 2, source));
}

struct Outcome {
  int iterations = 0;
  double milliseconds = 0;
  Termination end = Termination::non_finite;
};

using Solve = std::function<SolveReport(const Problem&, CoordinatePath&, double s0)>;

Outcome measure(const Problem& problem, int n, const Solve& solve, int repetitions) {
  const FirstPath first = StraightInitializer().first_path(problem, {});
  const CoordinatePath start = sample_equally(problem, first.path, n);
  const double s0 = PathEnergy(problem, 1).cost(start) / (n + 1);
  Outcome best{0, std::numeric_limits<double>::infinity(), Termination::non_finite};
  for (int i = 0; i < repetitions; ++i) {
    CoordinatePath path = start;
    const auto begin = std::chrono::steady_clock::now();
    const SolveReport report = solve(problem, path, s0);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    best = {report.iterations, std::min(best.milliseconds, ms), report.termination};
  }
  return best;
}

Solve direct(std::shared_ptr<const Solver> solver) {
  return [solver](const Problem& problem, CoordinatePath& path, double s0) {
    PathEnergy energy(problem, s0);
    return solver->solve(energy, path, {});
  };
}

Solve cascade(std::shared_ptr<const Solver> solver) {
  return [solver](const Problem& problem, CoordinatePath& path, double s0) {
    return solve_by_cascade(problem, *solver, s0, path, {});
  };
}

void print_row(const char* problem, const char* kernel, const char* solver, const std::vector<int>& sizes,
               const std::vector<Outcome>& row) {
  std::printf("| %-12s | %-12s | %-16s |", problem, kernel, solver);
  for (const Outcome& o : row)
    std::printf(" %5d%s %9.2f |", o.iterations, o.end == Termination::converged ? " " : "*", o.milliseconds);
  std::printf(" %5.2f | %5.2f |\n", static_cast<double>(row.back().iterations) / row.front().iterations,
              row.back().milliseconds / row.front().milliseconds * sizes.front() / sizes.back());
}

void table(std::vector<Case>& cases) {
  const std::vector<int> sizes = {20, 200, 2000, 20000};
  std::printf(
      "Iterations and milliseconds at n = 20, 200, 2000, 20000 (* not converged); iterations and time per point at "
      "n = 20000 relative to n = 20\n");
  const std::vector<std::pair<const char*, Solve>> solvers = {{"newton", direct(std::make_shared<Newton>())},
                                                              {"lbfgs chain", direct(std::make_shared<Lbfgs>())},
                                                              {"newton, cascade", cascade(std::make_shared<Newton>())}};
  for (Case& c : cases)
    for (const auto& [kernel_name, kernel] :
         {std::pair{"square", make_kernel<Square>()}, std::pair{"expm1_square", make_kernel<Expm1Square>()}})
      for (const auto& [name, solve] : solvers) {
        c.problem.kernel = kernel;
        std::vector<Outcome> row;
        for (const int n : sizes) row.push_back(measure(c.problem, n, solve, n > 2000 ? 3 : 5));
        print_row(c.name, kernel_name, name, sizes, row);
      }
}

void against_plain(std::vector<Case>& cases) {
  std::printf(
      "\nAgainst plain L-BFGS at n = 1000, same tolerance (relative cost error 1e-14, confirmed by the chain "
      "Hessian)\n");
  LbfgsOptions options;
  options.precondition = "none";
  options.max_iterations = 20000;
  options.max_evaluations = 100000;
  for (Case& c : cases) {
    c.problem.kernel = make_kernel<Expm1Square>();
    const Outcome plain = measure(c.problem, 1000, direct(std::make_shared<Lbfgs>(options)), 1);
    const Outcome chain = measure(c.problem, 1000, direct(std::make_shared<Lbfgs>()), 5);
    const Outcome newton = measure(c.problem, 1000, direct(std::make_shared<Newton>()), 5);
    std::printf(
        "| %-12s | plain %6d it%s %9.1f ms | chain %7.2f ms, %6.0f x faster | newton %7.2f ms, %6.0f x faster |\n",
        c.name, plain.iterations, plain.end == Termination::converged ? "" : "*", plain.milliseconds,
        chain.milliseconds, plain.milliseconds / chain.milliseconds, newton.milliseconds,
        plain.milliseconds / newton.milliseconds);
  }
}

}  // namespace

int main() {
  std::vector<Case> cases = {{"chute, rest", chute(0, {std::numbers::pi, -2})},
                             {"chute, moving", chute(1, {1, -1})},
                             {"half-plane", in_plane({0, 1}, {2, 3}, make_segment_cost(HalfPlane{}))}};
  table(cases);
  against_plain(cases);
}
