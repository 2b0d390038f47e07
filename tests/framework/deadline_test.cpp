// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <numbers>

#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/overrun.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_domains.hpp"
#include "tests/support/straightened.hpp"

namespace leastcost::test {
namespace {

struct Search {
  const char* name;
  Problem problem;
  std::shared_ptr<const Initializer> initializer;
  FindOptions options;
};

FindOptions traced() {
  FindOptions options;
  options.post_processors = {std::make_shared<const TracePostProcessor>(),
                             std::make_shared<const StraightenPostProcessor>()};
  return options;
}

std::vector<Search> searches() {
  const Eigen::Vector3d a(0.1, 0.2, 0.97), b(0.9, -0.3, -0.3);
  const auto straight = std::make_shared<const StraightInitializer>();
  const auto dijkstra = std::make_shared<const DijkstraInitializer>();
  const auto cost = make_euclidean_cost(3);
  const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(5)));
  const auto cloud = std::make_shared<const PointCloudManifold>(PointCloud(sphere_cloud(2000), {}));
  std::vector<Search> all = {
      {"plane", bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(std::numbers::pi, -2)), straight, {}},
      {"sphere", between(std::make_shared<Sphere>(), cost, a, b), straight, {}},
      {"mesh", between(mesh, cost, a, b), dijkstra, traced()},
      {"cloud", between(cloud, cost, a, b), dijkstra, {}},
  };
  prepare(all.back().problem);
  return all;
}

/// What an interrupted result may look like.
void check_honest(const Result& result) {
  if (result.status != Status::interrupted) return;
  CHECK_FALSE(result.certificate.certified());
  CHECK(std::isnan(result.certificate.estimate.error));
  CHECK(result.path.u.allFinite());
  if (result.path.u.size() == 0) {
    CHECK_FALSE(result.notes.empty());
    return;
  }
  CHECK(result.costs.size() == result.path.segment_count());
  const double sum = result.costs.sum();
  CHECK((std::isnan(sum) || std::isfinite(sum)));
}

}  // namespace

// A busy machine may stop this program at any place, for longer than the budget: what is late once is tried again, and
// what is late by itself is late each time.
TEST_CASE("deadline: a thousand random ones are kept", "[framework]") {
  constexpr double kGenerous = 30;  // this may be a sanitizer; benchmarks/deadline_table measures
  constexpr int kTries = 5;
  const std::vector<Search> all = searches();
  const Newton newton;
  const Lbfgs lbfgs;
  Random random(7);
  int interrupted = 0;
  for (int i = 0; i < 1000; ++i) {
    const Search& search = all[static_cast<std::size_t>(i) % all.size()];
    const Solver& solver = i / 4 % 2 == 0 ? static_cast<const Solver&>(newton) : lbfgs;
    FindOptions options = search.options;
    options.points = static_cast<int>(20 * std::pow(i % 4 == 3 ? 5 : 100, random.uniform(0, 1)));
    options.cascade = i % 5 == 0;
    options.escape_saddle = i % 7 == 0;
    const double budget = 1e-5 * std::pow(1000, random.uniform(0, 1));  // 10 us to 10 ms
    CAPTURE(i, search.name, solver.name(), *options.points, budget);
    const double allowed = kGenerous * std::max(1e-3, budget / 10);
    Result result;
    double over = 2 * allowed;
    for (int k = 0; k < kTries && over > allowed; ++k) {
      Monitor monitor;
      monitor.deadline = Monitor::Clock::now() +
                         std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(budget));
      over = overrun(*monitor.deadline,
                     [&] { result = find_path(search.problem, *search.initializer, solver, options, monitor); });
      check_honest(result);
    }
    CHECK(over <= allowed);
    interrupted += result.status == Status::interrupted ? 1 : 0;
  }
  CHECK(interrupted > 300);
}

TEST_CASE("deadline: no Hessian is built and no certificate begun after it", "[framework]") {
  Monitor monitor;
  std::vector<Stage> stages;
  monitor.deadline = Monitor::Clock::now() + std::chrono::hours(1);
  monitor.observe = [&](const Progress& progress) {
    if (progress.iteration == nullptr) stages.push_back(progress.stage);
    if (progress.stage == Stage::solve) monitor.deadline = Monitor::Clock::now();
  };
  FindOptions options;
  options.points = 2000;
  const Problem problem = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(std::numbers::pi, -2));
  const Result result = find_path(problem, StraightInitializer(), Newton(), options, monitor);
  CHECK(result.status == Status::interrupted);
  CHECK(result.solve.termination == Termination::time_limit);
  CHECK(result.solve.counters.hessians <= 1);
  CHECK(stages == std::vector<Stage>{Stage::initialize, Stage::solve});
  check_honest(result);
  REQUIRE(result.path.u.cols() == 2002);

  Result completed = result;
  complete_interrupted(problem, options, completed);
  CHECK(completed.status == Status::interrupted);
  CHECK(completed.post_processed);
  CHECK(completed.curve.cost == Approx(PathEnergy(problem, 1).cost(result.path)).epsilon(1e-14));
}

TEST_CASE("deadline: parts of a pass give the numbers of the whole pass", "[framework]") {
  const Problem problem = between(std::make_shared<Sphere>(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0),
                                  Eigen::Vector3d(0, 0.6, 0.8));
  Monitor late;
  late.deadline = Monitor::Clock::now() + std::chrono::hours(1);
  FindOptions options;
  options.points = 300;
  const Result with = find_path(problem, StraightInitializer(), Newton(), options, late);
  const Result without = find_path(problem, StraightInitializer(), Newton(), options);
  CHECK(with.status == Status::certified);
  CHECK(with.path.u == without.path.u);
  CHECK(with.certificate.estimate.value == without.certificate.estimate.value);
}

TEST_CASE("deadline: the coarser version of a cloud is made before it, or not at all", "[framework]") {
  const auto cloud = std::make_shared<const PointCloudManifold>(PointCloud(sphere_cloud(2000), {}));
  const Problem problem = between(cloud, make_euclidean_cost(3), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0));
  Monitor late;
  late.deadline = Monitor::Clock::now() + std::chrono::hours(1);
  FindOptions options;
  options.points = 15;
  const Result unprepared = find_path(problem, StraightInitializer(), Newton(), options, late);
  CHECK_FALSE(cloud->has_made_coarser());
  CHECK(failed(unprepared.certificate, "geometry_error"));
  prepare(problem);
  CHECK(cloud->has_made_coarser());
  CHECK(find_path(problem, StraightInitializer(), Newton(), options, late).certificate.geometry_error.has_value());
}

TEST_CASE("deadline: the search tree of a mesh is made before it, or given up at it", "[framework]") {
  constexpr double kTree = 0.1, kLate = 0.04;  // thread seconds: of a whole tree, at least; of what is left of it here
  const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(7)));
  Problem placed;
  placed.manifold = mesh;
  placed.cost = make_euclidean_cost(3);
  placed.kernel = make_kernel<Expm1Square>();
  placed.source = mesh->vertex(0);
  placed.target = mesh->vertex(20);
  Problem problem = placed;
  problem.source.site = problem.target.site = kNoSite;
  FindOptions options{.points = 15};
  options.certificate.enabled = false;
  const auto late_with = [&](const Problem& asked, const Initializer& initializer, bool path) {
    Monitor monitor;
    monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(10);
    Result result;
    const double late =
        overrun(*monitor.deadline, [&] { result = find_path(asked, initializer, Newton(), options, monitor); });
    CHECK(result.status == Status::interrupted);
    CHECK((result.path.u.size() > 0) == path);
    CHECK(late < kLate);
  };
  late_with(problem, DijkstraInitializer(), false);           // the ends ask for it
  late_with(placed, BowInitializer({.height = 0.3}), false);  // the first path
  const CoordinatePath edges = DijkstraInitializer().first_path(placed, {}).path;
  CHECK_FALSE(mesh->is_asked_by(edges));
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(10);
  Result result;
  CHECK(overrun(*monitor.deadline, [&] { result = improve_path(placed, edges, Lbfgs(), options, monitor); }) < kLate);
  CHECK(result.status == Status::interrupted);
  CHECK(result.path.u.cols() == edges.u.cols());
  CHECK_THROWS_AS(mesh->make(Monitor::Clock::now()), Interrupted);

  const auto begin = Monitor::Clock::now();
  prepare(placed);
  CHECK(std::chrono::duration<double>(Monitor::Clock::now() - begin).count() > kTree / 4);
  CHECK_NOTHROW(mesh->make(Monitor::Clock::now()));  // it is kept
}

}  // namespace leastcost::test
