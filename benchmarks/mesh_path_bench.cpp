// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The stages of a geodesic query on a mesh: first path along edges (and diagonals), trace of a chain, straightening.
// Mesh: $LEASTCOST_DATA/meshes/duck.obj as it is and after 3 subdivisions (argument), 20 pairs of its vertices; time
// per query.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <vector>

#include <leastcost/framework/certificate/certify.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include "problems/mesh/trace.hpp"

namespace {

using namespace leastcost;

constexpr int kPairs = 20;
constexpr int kChain = 50;  // points of a solver's chain

std::filesystem::path model() {
  const char* data = std::getenv("LEASTCOST_DATA");
  return std::filesystem::path(data ? data : "../shared/data") / "meshes/duck.obj";
}

double length(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); }

/// The same pairs of points at every level of subdivision.
struct Case {
  explicit Case(int subdivide) : mesh(read_mesh(model()), {false, subdivide}), graph(mesh), search(mesh) {
    for (int i = 1; i <= kPairs; ++i) {
      const std::int32_t v = static_cast<std::int32_t>(std::int64_t{i} * 245489 % mesh.file_vertex_count());
      targets.push_back(mesh.vertex_of_file(v));
      edge_paths.push_back(edge_path(targets.back(), false).path);
      const SurfacePath straight = straighten(mesh, edge_paths.back()).path;
      chains.push_back(resample(mesh, straight, kChain));
      traces.push_back(trace_chain(mesh, chains.back()).path);
    }
  }
  EdgePath edge_path(std::int32_t target, bool diagonals) {
    const Eigen::Vector3d goal = mesh.position(target);
    EdgePathOptions options;
    options.lower_bound = [goal](const Eigen::Vector3d& p) { return (goal - p).norm(); };
    options.diagonals = diagonals;
    return graph.shortest(vertex_point(mesh, 0), vertex_point(mesh, target), length, options);
  }

  TriangleMesh mesh;
  EdgeGraphSearch graph;
  GeodesicSearch search;
  std::vector<std::int32_t> targets;
  std::vector<SurfacePath> edge_paths, traces;
  std::vector<std::vector<SurfacePoint>> chains;
};

Case& duck(benchmark::State& state) {
  static std::map<int, Case> cases;
  const int subdivide = static_cast<int>(state.range(0));
  return cases.try_emplace(subdivide, subdivide).first->second;
}

/// Runs `stage(case, pair)` over the pairs in turn.
template <class Stage>
void each_pair(benchmark::State& state, Stage stage) {
  if (!std::filesystem::exists(model())) return state.SkipWithError("no duck.obj: set LEASTCOST_DATA");
  Case& c = duck(state);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(stage(c, i++ % kPairs));
  state.counters["vertices"] = c.mesh.vertex_count();
}

void edges(benchmark::State& state) {
  each_pair(state, [](Case& c, std::size_t i) { return c.edge_path(c.targets[i], false).cost; });
}
void edges_and_diagonals(benchmark::State& state) {
  each_pair(state, [](Case& c, std::size_t i) { return c.edge_path(c.targets[i], true).cost; });
}
void trace(benchmark::State& state) {
  each_pair(state, [](Case& c, std::size_t i) { return trace_chain(c.mesh, c.chains[i]).path.faces.size(); });
}
void straighten_trace(benchmark::State& state) {
  each_pair(state, [](Case& c, std::size_t i) { return straighten(c.mesh, c.traces[i]).final_length; });
}
void straighten_edge_path(benchmark::State& state) {
  each_pair(state, [](Case& c, std::size_t i) { return straighten(c.mesh, c.edge_paths[i]).final_length; });
}
void certify(benchmark::State& state) {
  each_pair(state, [](Case& c, std::size_t i) { return check_straight(c.mesh, c.traces[i]); });
}
void whole_query(benchmark::State& state) {
  each_pair(state, [](Case& c, std::size_t i) {
    return c.search.shortest(vertex_point(c.mesh, 0), vertex_point(c.mesh, c.targets[i])).result.final_length;
  });
}

}  // namespace

BENCHMARK(edges)->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(edges_and_diagonals)->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(trace)->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(straighten_trace)->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(straighten_edge_path)->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(certify)->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(whole_query)->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);
