// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// A whole mesh query, split per stage: the 2K duck, and the same geometry with 135K vertices, at fixed n = 47.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/solvers/lbfgs.hpp>

namespace {

using namespace leastcost;

struct Stages {
  std::vector<double> initialize, solve, trace, straighten, total;
  double faces = 0;
};

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return 1e3 * v[v.size() / 2];
}

PathEnd end_at(const MeshManifold& domain, int file_vertex) {
  const std::int32_t v = domain.mesh().vertex_of_file(file_vertex);
  return {domain.mesh().position(v), vertex_point(domain.mesh(), v).face};
}

Stages measure(const std::filesystem::path& file, int subdivide) {
  const auto domain = make_mesh_manifold({file.string(), false, subdivide}, "");
  const DijkstraInitializer initializer;
  const auto trace = std::make_shared<const TracePostProcessor>();
  const auto straighten = std::make_shared<const StraightenPostProcessor>();
  const Lbfgs solver;
  Stages stages;
  FindOptions options;
  options.points = 47;
  options.certificate.enabled = false;
  for (int round = 0; round < 3; ++round)
    for (int target = 100; target < 2100; target += 100) {
      Problem problem{domain, make_euclidean_cost(3), make_kernel<Expm1Square>(), end_at(*domain, 0),
                      end_at(*domain, target)};
      options.post_processors = {trace};
      const Result traced = find_path(problem, initializer, solver, options);
      options.post_processors = {trace, straighten};
      const Result full = find_path(problem, initializer, solver, options);
      if (round == 0) {
        stages.faces += static_cast<double>(full.curve.segment_sites.size()) / 20;
        continue;  // warm-up
      }
      stages.initialize.push_back(full.seconds.initialize);
      stages.solve.push_back(full.seconds.solve);
      stages.trace.push_back(traced.seconds.post_process);
      stages.straighten.push_back(full.seconds.post_process - traced.seconds.post_process);
      stages.total.push_back(full.seconds.initialize + full.seconds.solve + full.seconds.post_process);
    }
  return stages;
}

void print(const char* name, const Stages& s) {
  std::printf("| %-22s | %7.3f | %7.3f | %7.3f | %10.3f | %7.3f | %6.0f |\n", name, median(s.initialize),
              median(s.solve), median(s.trace), median(s.straighten), median(s.total), s.faces);
}

}  // namespace

int main() {
  const char* root = std::getenv("LEASTCOST_DATA");
  const std::filesystem::path data =
      root ? std::filesystem::path(root) : std::filesystem::path(LEASTCOST_PROJECT_DIR) / "../shared/data";
  const std::filesystem::path file = data / "meshes/duck.obj";
  if (!std::filesystem::exists(file)) {
    std::printf("skipped: %s is not there (set LEASTCOST_DATA)\n", file.c_str());
    return 0;
  }
  std::printf("Median milliseconds per query, 20 targets, n = 47\n");
  std::printf("| mesh                   | first   | solve   | trace   | straighten | total   | faces  |\n");
  const Stages coarse = measure(file, 0), fine = measure(file, 3);
  print("duck, 2K vertices", coarse);
  print("subdivide 3, 135K", fine);
  std::printf(
      "ratios: solve %.2f (target 1.5), trace + straighten %.1f against crossed faces %.1f; total at 2K %.2f ms "
      "(target 3)\n",
      median(fine.solve) / median(coarse.solve),
      (median(fine.trace) + median(fine.straighten)) / (median(coarse.trace) + median(coarse.straighten)),
      fine.faces / coarse.faces, median(coarse.total));
}
