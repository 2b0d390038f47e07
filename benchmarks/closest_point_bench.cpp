// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Closest points on a mesh: the query that moving path points ask all the time. Mesh:
// $LEASTCOST_DATA/meshes/bunny_70k.obj, else the same model as Debian's glmark2-data installs it.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <random>
#include <vector>

#include <leastcost/problems/mesh/closest_point.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>

namespace {

using leastcost::ClosestPoint;
using leastcost::ClosestPointTree;
using leastcost::TriangleMesh;

constexpr unsigned kSeed = 1;

std::filesystem::path model() {
  const char* data = std::getenv("LEASTCOST_DATA");
  const std::filesystem::path shared = std::filesystem::path(data ? data : "../shared/data") / "meshes/bunny_70k.obj";
  return std::filesystem::exists(shared) ? shared : std::filesystem::path("/usr/share/glmark2/models/bunny.obj");
}

const TriangleMesh& mesh() {
  static const TriangleMesh instance(leastcost::read_mesh(model()));
  return instance;
}

const ClosestPointTree& tree() {
  static const ClosestPointTree instance(mesh());
  return instance;
}

/// Points at `away` diameters from the surface, in random directions.
std::vector<Eigen::Vector3d> points_near(double away) {
  std::mt19937_64 engine(kSeed);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> points(4096);
  for (Eigen::Vector3d& p : points) {
    const std::int32_t face = static_cast<std::int32_t>(engine() % static_cast<std::uint64_t>(mesh().face_count()));
    const double x = normal(engine), y = normal(engine), z = normal(engine);
    p = mesh().point({face, {0.3, 0.3, 0.4}}) + away * mesh().diameter() * Eigen::Vector3d(x, y, z);
  }
  return points;
}

/// A point slides over the surface in steps of 3e-4 diameters, each time projected back from where it was.
void hinted_query(benchmark::State& state) {
  const std::vector<Eigen::Vector3d> steps = points_near(3e-4);
  const std::vector<Eigen::Vector3d> starts = points_near(0);
  ClosestPoint here = tree().nearest(starts[0]);
  std::size_t i = 0;
  for (auto _ : state) {
    if (i % 256 == 0) here = tree().nearest(starts[i % starts.size()]);
    const Eigen::Vector3d step = steps[i % 256] - starts[i % 256];
    here = tree().nearest(here.position + step, here.where.face);
    benchmark::DoNotOptimize(here);
    ++i;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(hinted_query);

/// The argument: distance from the surface, 1e-6 diameters.
void unhinted_query(benchmark::State& state) {
  const std::vector<Eigen::Vector3d> points = points_near(1e-6 * static_cast<double>(state.range(0)));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(tree().nearest(points[i++ % points.size()]));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(unhinted_query)->Arg(0)->Arg(1000)->Arg(1000000);

void build_mesh(benchmark::State& state) {
  const leastcost::PolygonSoup soup = leastcost::read_mesh(model());
  for (auto _ : state) benchmark::DoNotOptimize(TriangleMesh(soup).face_count());
}
BENCHMARK(build_mesh)->Unit(benchmark::kMillisecond);

void build_tree(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(ClosestPointTree(mesh()).nearest(Eigen::Vector3d::Zero()));
}
BENCHMARK(build_tree)->Unit(benchmark::kMillisecond);

void read_file(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(leastcost::read_mesh(model()).positions.size());
}
BENCHMARK(read_file)->Unit(benchmark::kMillisecond);

}  // namespace
