// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Projections onto the moving least squares surface of 100,000 points, the query that path points ask all the time: a
// sampled torus, and $LEASTCOST_DATA/points/building_100k.ply where it is at hand. items_per_second is projections per
// second of processor time.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <leastcost/problems/cloud/cloud_surface.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>

namespace {

using Eigen::Vector3d;
using leastcost::CloudSurface;
using leastcost::PointCloud;
using leastcost::PointSamples;

constexpr int kSize = 100000;
constexpr unsigned kSeed = 1;
constexpr std::size_t kPath = 256;  ///< points of a path, neighbours in space

/// Quasi-random points of the torus with radii 2 and 1, uniform by area.
PointSamples torus() {
  PointSamples samples;
  const double g = 1.32471795724474602596;  // the plastic number: g^3 = g + 1
  for (int i = 1; i <= kSize; ++i) {
    const double u = 2 * std::numbers::pi * std::fmod(0.5 + i / g, 1.0);
    const double m = 2 * std::numbers::pi * std::fmod(0.5 + i / (g * g), 1.0);
    double v = m;
    for (int k = 0; k < 20; ++k) v -= (2 * v + std::sin(v) - 2 * m) / (2 + std::cos(v));
    samples.positions.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
  }
  return samples;
}

const PointCloud& torus_cloud() {
  static const PointCloud cloud(torus(), {});
  return cloud;
}

/// Null where the file is not there.
const PointCloud* building_cloud() {
  static const std::unique_ptr<const PointCloud> cloud = [] {
    const char* data = std::getenv("LEASTCOST_DATA");
    const std::filesystem::path file =
        std::filesystem::path(data ? data : "../shared/data") / "points/building_100k.ply";
    return std::filesystem::exists(file)
               ? std::make_unique<const PointCloud>(leastcost::read_point_cloud(file), leastcost::PointCloudSettings{})
               : nullptr;
  }();
  return cloud.get();
}

/// Trial points as a solver makes them: paths of kPath points on the surface, a fifth of a spacing apart, each stepped
/// along its tangent plane by a tenth of a spacing.
std::vector<Vector3d> trial_points(const PointCloud& cloud) {
  std::mt19937_64 engine(kSeed);
  std::normal_distribution<double> normal;
  const CloudSurface surface(cloud);
  std::vector<Vector3d> points;
  while (points.size() < 64 * kPath) {
    const auto start = static_cast<std::int32_t>(engine() % static_cast<std::uint64_t>(cloud.size()));
    Vector3d x = cloud.sample(start).position + cloud.centre();
    if (!surface.project(x)) continue;
    Vector3d way(normal(engine), normal(engine), normal(engine));
    std::vector<Vector3d> path;
    while (path.size() < kPath) {
      const auto n = surface.normal(x);
      if (!n) break;
      way = (way - n->dot(way) * *n).normalized();
      Vector3d aside(normal(engine), normal(engine), normal(engine));
      aside -= n->dot(aside) * *n;
      path.emplace_back(x + 0.1 * cloud.spacing(start) * aside);
      x += 0.2 * cloud.spacing(start) * way;
      if (!surface.project(x)) break;
    }
    if (path.size() == kPath) points.insert(points.end(), path.begin(), path.end());
  }
  return points;
}

void project(benchmark::State& state, const PointCloud& cloud) {
  const std::vector<Vector3d> points = trial_points(cloud);
  const CloudSurface surface(cloud);
  std::size_t i = 0, missed = 0;
  for (auto _ : state) {
    Vector3d x = points[i++ % points.size()];
    missed += surface.project(x) ? 0 : 1;
    benchmark::DoNotOptimize(x);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["missed"] = static_cast<double>(missed) / static_cast<double>(state.iterations());
}

void project_on_torus(benchmark::State& state) { project(state, torus_cloud()); }
BENCHMARK(project_on_torus);

void project_on_building(benchmark::State& state) {
  if (building_cloud() == nullptr) return state.SkipWithError("points/building_100k.ply is not here");
  project(state, *building_cloud());
}
BENCHMARK(project_on_building);

void normals_of_torus(benchmark::State& state) {
  const std::vector<Vector3d> points = trial_points(torus_cloud());
  const CloudSurface surface(torus_cloud());
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(surface.normal(points[i++ % points.size()]));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(normals_of_torus);

void prepare_torus(benchmark::State& state) {
  const PointSamples samples = torus();
  for (auto _ : state) benchmark::DoNotOptimize(PointCloud(samples, {}).size());
}
BENCHMARK(prepare_torus)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
