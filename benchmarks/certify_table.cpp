// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What a certificate costs on clouds and on grids made from them: processor time of making the domain, of making its
// coarser versions (once per domain), of a cold Newton solve, and of the certificate against it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>

#include <leastcost/framework/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/point_cloud.hpp>
#include <leastcost/problems/manifolds/signed_distance.hpp>
#include <leastcost/solvers/newton.hpp>
#include "benchmarks/measure.hpp"
#include "problems/distance/cloud_distance.hpp"
#include "tests/problems/sample_clouds.hpp"

namespace {

using namespace leastcost;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double seconds_of(Work work) {
  const double begin = cpu_seconds();
  work();
  return cpu_seconds() - begin;
}

std::shared_ptr<const ConstraintManifold> cloud_of(const PointSamples& samples) {
  return std::make_shared<const PointCloudManifold>(PointCloud(samples, {}));
}

std::shared_ptr<const ConstraintManifold> grid_of(const PointSamples& samples) {
  const auto source = make_cloud_distance(PointCloud(samples, {}), true);
  return std::make_shared<const SignedDistanceManifold>(build_distance_grid(*source, {}), source);
}

/// The torus of test::torus_cloud() at (u, v) = (1.5 t, 1.1 t).
Eigen::Vector3d on_torus(double t) {
  const double u = 1.5 * t, v = 1.1 * t, r = 2 + std::cos(v);
  return {r * std::cos(u), r * std::sin(u), std::sin(v)};
}

/// The least of three.
template <class Work>
double least_seconds_of(Work work) {
  double least = seconds_of(work);
  for (int i = 0; i < 2; ++i) least = std::min(least, seconds_of(work));
  return least;
}

template <class Make>
void print_rows(const std::string& name, Make make) {
  Problem problem;
  const double made = seconds_of([&] { problem.manifold = make(); });
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source = project_end(*problem.manifold, on_torus(0));
  problem.target = project_end(*problem.manifold, on_torus(1));
  const double coarser = seconds_of([&] { prepare(problem); });
  constexpr Index kWaypoints = 9;
  Points waypoints(3, kWaypoints);
  for (Index i = 0; i < kWaypoints; ++i) waypoints.col(i) = on_torus(static_cast<double>(i + 1) / (kWaypoints + 1));
  bench::Case c{name.c_str(), problem, std::make_shared<WaypointsInitializer>(waypoints)};
  for (const int n : {31, 63, 200}) {
    const CoordinatePath start = sample_equally(problem, c.initializer->first_path(problem, {}).path, n);
    const double s0 = PathEnergy(problem, 1).cost(start) / static_cast<double>(start.segment_count());
    const double solve = least_seconds_of([&] {
      CoordinatePath path = start;
      PathEnergy energy(problem, s0);
      Newton().solve(energy, path, {});
    });
    FindOptions options{.points = n};
    options.certificate.enabled = false;
    const double without = least_seconds_of([&] { find_path(problem, *c.initializer, Newton(), options); });
    options.certificate.enabled = true;
    Result result;
    const double with = least_seconds_of([&] { result = find_path(problem, *c.initializer, Newton(), options); });
    std::printf("| %-16s | %4d | %7.3f | %7.3f | %5.2f | %8.2f | %2d | %8.2f | %5.1f | %s\n", c.name, n, made, coarser,
                coarser / made, 1e3 * solve, result.solve.iterations, 1e3 * (with - without), (with - without) / solve,
                std::string(leastcost::name(result.status)).c_str());
    std::fflush(stdout);
  }
}

}  // namespace

int main() {
  std::printf("| domain | n | made, s | coarser, s | ratio | solve, ms | iterations | certify, ms | ratio | status\n");
  for (const int count : {5000, 20000, 100000})
    print_rows("cloud of " + std::to_string(count), [&] { return cloud_of(test::torus_cloud(count)); });
  for (const int count : {5000, 20000})
    print_rows("grid from " + std::to_string(count), [&] { return grid_of(test::torus_cloud(count)); });
}
