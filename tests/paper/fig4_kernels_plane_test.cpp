// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Fig. 4: H = s, s^2, exp(s^2) - 1 on the plane with 200 points by plain L-BFGS. The paper compares at s0 = 1 in
// its own units; here all three have s0 = the mean segment of the start, which takes the units out of it
// (docs/numerics.md Sec. 2.2).
#include <algorithm>
#include <cstdio>
#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

constexpr int kPoints = 200;

Problem plane(const std::shared_ptr<const Kernel>& kernel) {
  return between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), kernel);
}

/// A wave from end to end, equally spaced, 49 % too long.
CoordinatePath wave(const Problem& problem) {
  CoordinatePath dense{Points(2, 4001), {}, false};
  for (Index i = 0; i < dense.u.cols(); ++i) {
    const double t = static_cast<double>(i) / 4000;
    dense.u.col(i) << t, 0.25 * std::sin(2 * std::numbers::pi * t);
  }
  dense.u.rightCols(1) = problem.target.u;
  return sample_equally(problem, dense, kPoints);
}

struct KernelRun {
  std::vector<double> errors;  ///< relative error of the length after 0, 1, 2, .. iterations
  double spread = 0;           ///< at the end
  Termination end = Termination::non_finite;
};

/// Plain L-BFGS, one iteration more at a time (a prefix of one run is a run).
KernelRun run(const std::shared_ptr<const Kernel>& kernel) {
  const Problem problem = plane(kernel);
  const CoordinatePath start = wave(problem);
  PathEnergy energy(problem, PathEnergy(problem, 1).cost(start) / (kPoints + 1));
  KernelRun result;
  for (const int iterations : {1, 10, 30, 100, 200, 300, 500, 1000, 3000}) {
    CoordinatePath path = start;
    const Lbfgs solver({.tolerance = 0, .max_iterations = iterations, .precondition = Preconditioner::none});
    result.end = solver.solve(energy, path, {}).termination;
    result.errors.push_back(energy.cost(path) - 1);
    result.spread = spread(energy.costs(path));
  }
  return result;
}

}  // namespace

TEST_CASE("Fig. 4: kernels on the plane by plain L-BFGS, at equal s0", "[paper]") {
  const KernelRun s = run(make_kernel<Linear>()), square = run(make_kernel<Square>()),
                  exponential = run(make_kernel<Expm1Square>());
  std::printf("Fig. 4, relative error of the length after 1, 10, 30, 100, 200, 300, 500, 1000, 3000 iterations\n");
  for (const auto& [name, r] :
       {std::pair{"s", &s}, std::pair{"s^2", &square}, std::pair{"exp(s^2) - 1", &exponential}}) {
    std::printf("  %-13s", name);
    for (const double e : r->errors) std::printf(" %.1e", e);
    std::printf("   spread %.1e, %s\n", r->spread, std::string(leastcost::word_of(r->end)).c_str());
  }
  for (const KernelRun* r : {&s, &square, &exponential})
    for (const double e : r->errors) CHECK(e > -1e-14);  // never shorter than the line
  // Both strictly convex kernels find the line and its equal spacing, in a comparable number of iterations.
  CHECK(square.errors.back() < 1e-8);
  CHECK(exponential.errors.back() < 1e-8);
  CHECK(square.spread < 1e-3);
  CHECK(exponential.spread < 1e-3);
  // H = s shortens the path as well but has no unique minimiser: the spacing it was given is gone and does not come
  // back.
  CHECK(s.errors.back() < 0.01);
  CHECK(s.spread > 1);
}

TEST_CASE("Fig. 4 by a chain solver: the number of points no longer matters", "[paper]") {
  for (const auto& kernel : {make_kernel<Square>(), make_kernel<Expm1Square>()}) {
    const Problem problem = plane(kernel);
    CoordinatePath path = wave(problem);
    PathEnergy energy(problem, PathEnergy(problem, 1).cost(path) / (kPoints + 1));
    const SolveReport report = Lbfgs().solve(energy, path, {});
    std::printf("Fig. 4, chain L-BFGS: %d iterations, error %.1e\n", report.iterations, energy.cost(path) - 1);
    CHECK(report.termination == Termination::converged);
    CHECK(report.iterations < 30);
    CHECK(energy.cost(path) == Approx(1).epsilon(1e-12));
    CHECK(spread(energy.costs(path)) < 1e-6);
  }
}

}  // namespace leastcost::test
