// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include "framework/energy/spacing.hpp"

/// What the tables of iterations share.
namespace leastcost::bench {

struct Case {
  const char* name;
  Problem problem;
  std::shared_ptr<const Initializer> initializer = std::make_shared<StraightInitializer>();
};

struct Outcome {
  int iterations = 0;
  double milliseconds = 0;
  Termination end = Termination::non_finite;
};

using Solve = std::function<SolveReport(const Problem&, CoordinatePath&, double s0)>;

inline Solve direct(std::shared_ptr<const Solver> solver) {
  return [solver](const Problem& problem, CoordinatePath& path, double s0) {
    PathEnergy energy(problem, s0);
    return solver->solve(energy, path, {});
  };
}

/// The solve alone, from n points equally spaced along the first path: the least time of the repetitions.
inline Outcome measure(const Case& c, int n, const Solve& solve, int repetitions) {
  const FirstPath first = c.initializer->first_path(c.problem, {});
  const CoordinatePath start = sample_equally(c.problem, first.path, n);
  const double s0 = PathEnergy(c.problem, 1).cost(start) / static_cast<double>(start.segment_count());
  Outcome best{0, std::numeric_limits<double>::infinity(), Termination::non_finite};
  for (int i = 0; i < repetitions; ++i) {
    CoordinatePath path = start;
    const auto begin = std::chrono::steady_clock::now();
    const SolveReport report = solve(c.problem, path, s0);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    best = {report.iterations, std::min(best.milliseconds, ms), report.termination};
  }
  return best;
}

inline void print_heading(const std::vector<int>& sizes) {
  std::printf("Iterations and milliseconds at n =");
  for (const int n : sizes) std::printf(" %d", n);
  std::printf(" (* not converged); iterations and time per point at the last n relative to the first\n");
}

inline void print_row(const char* problem, const char* kernel, const char* solver, const std::vector<int>& sizes,
                      const std::vector<Outcome>& row) {
  std::printf("| %-18s | %-12s | %-16s |", problem, kernel, solver);
  for (const Outcome& o : row)
    std::printf(" %5d%s %9.2f |", o.iterations, o.end == Termination::converged ? " " : "*", o.milliseconds);
  std::printf(" %5.2f | %5.2f |\n", static_cast<double>(row.back().iterations) / row.front().iterations,
              row.back().milliseconds / row.front().milliseconds * sizes.front() / sizes.back());
  std::fflush(stdout);
}

}  // namespace leastcost::bench
