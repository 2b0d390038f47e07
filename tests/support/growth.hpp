// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/compose.hpp"

namespace leastcost::test {

/// The three problems of the table of work against n: mild, steep at its first segment, far from its start.
inline std::vector<std::pair<std::string, Problem>> growth_problems() {
  const ParametricOptions torus{.surface = parametric::Torus{}};
  const MetricFieldOptions half_plane{.field = metric::HalfPlane{}};
  return {{"torus", between(make_parametric_manifold(torus), make_euclidean_cost(3), Eigen::Vector2d(0, 0),
                            Eigen::Vector2d(1, 2))},
          {"chute from rest", bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(3.141592653589793, -2))},
          {"half-plane near its boundary", between(space(2), make_metric_field_cost(half_plane, 2, nullptr, {}),
                                                   Eigen::Vector2d(0, 0.1), Eigen::Vector2d(2, 0.1))}};
}

/// Energies and gradients until the path is within a relative excess of cost of 1e-10 of the best chain of n points,
/// which newton finds. 0: never.
inline long evaluations_to_solve(const Problem& problem, int n, const Solver& solver) {
  const CoordinatePath start = sample_equally(problem, StraightInitializer().first_path(problem, {}).path, n);
  const double s0 = PathEnergy(problem, 1).cost(start) / static_cast<double>(start.segment_count());
  PathEnergy energy(problem, s0);
  CoordinatePath best = start, path = start;
  const double least = Newton().solve(energy, best, {}).final_energy;
  for (const Iteration& i : solver.solve(energy, path, {}).history)
    if (i.energy - least <= 1e-10 * energy.scale(best)) return i.evaluations;
  return 0;
}

/// At n = 2000 no more than twice the work at n = 20.
inline void check_flat(const Solver& solver, double most = 2) {
  for (const auto& [name, problem] : growth_problems()) {
    const long few = evaluations_to_solve(problem, 20, solver), many = evaluations_to_solve(problem, 2000, solver);
    CAPTURE(name, few, many);
    CHECK(few > 0);
    CHECK(many > 0);
    CHECK(static_cast<double>(many) <= most * static_cast<double>(few));
  }
}

}  // namespace leastcost::test
