// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Writes configs/studies/planning.yaml: scenes of discs whose optimum a tangent graph knows, which shares no code with
// ours. Only scenes whose path on a grid is of the class of the shortest are taken, so that what is left to a solver is
// known.
#include <cstdio>
#include <memory>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "benchmarks/disc_scene.hpp"
#include "tests/adversarial/planning/judge/tangent_graph.hpp"

namespace {

using namespace leastcost;

constexpr int kScenes = 100, kDiscs = 12;
constexpr double kGrain = 1e-3, kSameClass = 2e-6;

constexpr const char* kHead =
    R"(# Plans among discs: what solvers and designs make of 100 scenes with known optimum (12 discs in a square;
# an exact tangent graph). First paths come from a grid and are all of the class of the shortest path, so what is
# missing is the solver's. With post_process: [] the chain is delivered as it comes to rest beside the walls, with taut
# it is pulled tight; none moves nothing. Made by benchmarks/plan_study.
#
#   leastcost study configs/studies/planning.yaml -o results/planning -j 2      # about 5 minutes
name: planning
points: [50]
solvers: [none, newton, lbfgs, {name: nlopt ccsaq, type: nlopt, algorithm: ccsaq}, vfcs]
sweep:
  post_process: [[], [taut]]
max_evaluations: 20000
max_seconds: 20
problems:
)";

void write(const judge::Scene& scene, unsigned seed, double optimum) {
  std::printf("  - name: scene %u\n    optimum: %.15g\n    config:\n      manifold: euclidean\n      cost: euclidean\n",
              seed, optimum);
  std::printf(
      "      ends: {source: {point: [0, 0]}, target: {point: [10, 10]}}\n      initializer: grid\n      obstacles:\n");
  for (const judge::Thing& disc : scene.things)
    std::printf("        - {type: ball, center: [%.3f, %.3f], radius: %.3f}\n", disc.corners[0][0], disc.corners[0][1],
                disc.radius);
}

}  // namespace

int main() {
  std::fputs(kHead, stdout);
  FindOptions options;
  options.points = 50;
  options.post_processors = {std::make_shared<const TautPostProcessor>()};
  int found = 0;
  for (unsigned seed = 1; found < kScenes; ++seed) {
    const DiscScene scene = disc_scene(seed, kDiscs, kGrain);
    const auto best = judge::shortest_among_discs(scene.judged);
    if (!best) continue;
    const Result result = find_path(scene.problem, GridInitializer(), NoSolver(), options);
    if (result.status != Status::certified || !(result.curve.cost < *best * (1 + kSameClass))) continue;
    write(scene.judged, seed, *best);
    ++found;
  }
}
