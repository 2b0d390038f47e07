// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What a certificate costs: processor time of making the domain, of making its coarser versions (once per domain), of a
// cold Newton solve, and of the certificate against it, without and with a proof of the minimum.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
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

struct Made {
  double domain = 0, coarser = 0;  ///< seconds
};

/// Certificates without and with a proof of the minimum, which only formulas have.
void print_row(const bench::Case& c, int n, const Made& made) {
  const CoordinatePath start = sample_equally(c.problem, c.initializer->first_path(c.problem, {}).path, n);
  const double s0 = PathEnergy(c.problem, 1).cost(start) / static_cast<double>(start.segment_count());
  const double solve = least_seconds_of([&] {
    CoordinatePath path = start;
    PathEnergy energy(c.problem, s0);
    Newton().solve(energy, path, {});
  });
  FindOptions options{.points = n};
  Result result;
  const auto seconds = [&](bool certify, bool prove) {
    options.certificate.enabled = certify;
    options.certificate.proof = prove ? ProofRule::always : ProofRule::never;
    return least_seconds_of([&] { result = find_path(c.problem, *c.initializer, Newton(), options); });
  };
  const double without = seconds(false, false), certified = seconds(true, false) - without,
               proved = seconds(true, true) - without;
  const std::optional<Resolution>& resolution = result.certificate.resolution;
  std::printf("| %-18s | %4d | %7.3f | %7.3f | %7.2f | %2d | %8.2f | %5.1f | %8.2f | %6.1f | %s%s\n", c.name, n,
              made.domain, made.coarser, 1e3 * solve, result.solve.iterations, 1e3 * certified, certified / solve,
              1e3 * proved, proved / solve, leastcost::word_of(result.status).data(),
              resolution && resolution->minimum_proved ? ", proved" : "");
  std::fflush(stdout);
}

void print_rows(const bench::Case& c, const Made& made = {}) {
  for (const int n : {31, 63, 200}) print_row(c, n, made);
}

Problem between(std::shared_ptr<const ConstraintManifold> manifold, std::shared_ptr<const SegmentCost> cost,
                const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  Problem problem;
  problem.manifold = std::move(manifold);
  problem.cost = std::move(cost);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source = project_end(*problem.manifold, a);
  problem.target = project_end(*problem.manifold, b);
  return problem;
}

template <class Make>
void print_torus(const std::string& name, Make make) {
  std::shared_ptr<const ConstraintManifold> domain;
  Made made{seconds_of([&] { domain = make(); }), 0};
  const Problem problem = between(domain, make_euclidean_cost(3), on_torus(0), on_torus(1));
  made.coarser = seconds_of([&] { prepare(problem); });
  constexpr Index kWaypoints = 9;
  Points waypoints(3, kWaypoints);
  for (Index i = 0; i < kWaypoints; ++i) waypoints.col(i) = on_torus(static_cast<double>(i + 1) / (kWaypoints + 1));
  print_rows({name.c_str(), problem, std::make_shared<WaypointsInitializer>(waypoints)}, made);
}

std::shared_ptr<const SegmentCost> tensor(const std::vector<std::string>& entries, int dimension) {
  MetricFieldOptions options;
  options.field = metric::Formula{entries, {}};
  return make_metric_field_cost(options, dimension);
}

void print_formulas() {
  const auto flat = [](int dimension) {
    return std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = dimension});
  };
  const auto chart = [](const parametric::Surface& surface) { return make_parametric_manifold({.surface = surface}); };
  const std::string hill = "(1 + 2*exp(-2*(x^2 + y^2)))^2", hill3 = "(1 + 2*exp(-2*(x^2 + y^2 + z^2)))^2";
  using V2 = Eigen::Vector2d;
  using V3 = Eigen::Vector3d;
  print_rows({"hill, plane", between(flat(2), tensor({hill, "0", hill}, 2), V2(-2, 0.05), V2(2, 0.4))});
  print_rows({"hill, space",
              between(flat(3), tensor({hill3, "0", "0", hill3, "0", hill3}, 3), V3(-2, 0.05, 0.3), V3(2, 0.4, 0.1))});
  print_rows({"sphere, chart", between(chart(parametric::Sphere{}), make_euclidean_cost(3), V2(0, 0.2), V2(1.3, 0.7))});
  print_rows({"saddle, chart", between(chart(parametric::Formula{.x = "u", .y = "v", .z = "u^2 - v^2"}),
                                       make_euclidean_cost(3), V2(-1, 0.1), V2(1, 0.3))});
  print_rows({"torus, chart", between(chart(parametric::Torus{}), make_euclidean_cost(3), V2(0, 0), V2(1.5, 1.1))});
  print_rows({"torus, level set", between(make_implicit_manifold({.surface = implicit::Torus{}}),
                                          make_euclidean_cost(3), on_torus(0), on_torus(1))});
}

}  // namespace

int main() {
  std::printf(
      "| domain | n | made, s | coarser, s | solve, ms | iterations | certify, ms | over solve | with proof, ms | "
      "over solve | status\n");
  print_formulas();
  for (const int count : {5000, 20000, 100000})
    print_torus("cloud of " + std::to_string(count), [&] { return cloud_of(test::torus_cloud(count)); });
  for (const int count : {5000, 20000})
    print_torus("grid from " + std::to_string(count), [&] { return grid_of(test::torus_cloud(count)); });
}
