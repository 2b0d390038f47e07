// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Shortest paths on Moving AI maps after loading and meshing: the search over cells and the straightening alone, and a
// whole query (n = 64, solved and certified). Pairs spread over the buckets.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <numeric>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include "problems/mesh/mesh_curve.hpp"
#include "problems/mesh/trace.hpp"
#include "problems/readers/file_content.hpp"
#include "problems/readers/occupancy_reader.hpp"
#include "tests/support/scenario.hpp"

namespace {

using namespace leastcost;

template <class Work>
double milliseconds(const Work& work) {
  const std::clock_t begin = std::clock();  // of the processor: other programs may run beside
  work();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double mean(const std::vector<double>& v) {
  return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

struct Row {
  const char* name;
  double target;  ///< mean milliseconds of search and straightening
};

void measure(const std::filesystem::path& folder, const Row& row, std::size_t count) {
  const std::filesystem::path file = folder / (std::string(row.name) + ".map");
  if (!std::filesystem::exists(file)) {
    std::printf("skipped: %s is not there (set LEASTCOST_DATA)\n", file.c_str());
    return;
  }
  std::shared_ptr<const MapManifold> domain;
  const double load = milliseconds(
      [&] { domain = std::make_shared<const MapManifold>(read_moving_ai(read_content(file), file.string(), {})); });
  std::vector<double> search, straight, whole;
  double relative = 0;
  FindOptions options;
  options.post_processors = {std::make_shared<const TracePostProcessor>(),
                             std::make_shared<const StraightenPostProcessor>()};
  const auto pairs = test::spread_over(test::read_scenario(file.string() + ".scen"), count);
  for (const test::ScenarioPair& pair : pairs) {
    Problem problem{domain, make_euclidean_cost(2), make_kernel<Expm1Square>(), project_end(*domain, pair.source),
                    project_end(*domain, pair.target)};
    FirstPath first;
    search.push_back(milliseconds([&] { first = DijkstraInitializer().first_path(problem, {}); }));
    double length = 0;
    straight.push_back(milliseconds([&] {
      const SurfacePath route = trace_chain(domain->mesh(), surface_points(domain->mesh(), first.path)).path;
      length = straighten(domain->mesh(), route).final_length;
    }));
    relative += length / pair.optimum;
    whole.push_back(milliseconds([&] { find_path(problem, DijkstraInitializer(), Lbfgs(), options); }));
  }
  const double both = mean(search) + mean(straight);
  std::printf("| %-12s | %7.1f | %6d | %5zu | %7.3f | %10.3f | %7.3f | %6.2f | %7.3f | %6.4f |\n", row.name, load,
              domain->mesh().face_count(), pairs.size(), mean(search), mean(straight), both, both / row.target,
              mean(whole), relative / static_cast<double>(pairs.size()));
}

}  // namespace

int main(int argc, char** argv) {
  const char* root = std::getenv("LEASTCOST_DATA");
  const std::filesystem::path data =
      root ? std::filesystem::path(root) : std::filesystem::path(LEASTCOST_PROJECT_DIR) / "../shared/data";
  std::printf("Mean CPU milliseconds per query; the target is half of what a prototype took\n");
  std::printf(
      "| map          | load    | faces  | pairs | search  | straighten | both    | target | query   | length / octile "
      "|\n");
  for (const Row& row : {Row{"arena", 0.25}, Row{"arena2", 5}, Row{"32room_000", 38}, Row{"maze512-16-0", 176}})
    measure(data / "planning", row, argc > 1 ? static_cast<std::size_t>(std::atoi(argv[1])) : 200);
}
