// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Families from graph routes that keep away from each other: both sides of a hole, distinct locally shortest paths.
#include <algorithm>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <leastcost/framework/family/find_family.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

Family by_routes(const Problem& problem, int routes, const std::vector<std::shared_ptr<const PostProcessor>>& steps) {
  std::vector<FamilyStart> starts;
  for (int rank = 1; rank <= routes; ++rank)
    starts.push_back({"route " + std::to_string(rank), problem,
                      std::make_shared<const DijkstraInitializer>(DijkstraOptions{.routes = 1, .rank = rank})});
  const Newton newton;
  FindOptions options;
  options.points = 60;
  options.post_processors = steps;
  if (steps.empty()) return find_family(starts, newton, options);
  return find_family(starts, Lbfgs(), options);
}

}  // namespace

TEST_CASE("graph routes of a torus mesh go around both sides of the hole", "[oracle]") {
  const auto torus = std::make_shared<const MeshManifold>(TriangleMesh(grid(48, 24, Closing::kRound, true)));
  const Problem problem = between(torus, make_euclidean_cost(3), Eigen::Vector3d(4, 0, 0), Eigen::Vector3d(-4, 0, 0));
  const Family family = by_routes(
      problem, 4, {std::make_shared<const TracePostProcessor>(), std::make_shared<const StraightenPostProcessor>()});
  REQUIRE(family.members.size() >= 2);
  bool one_side = false, other_side = false;
  for (const FamilyMember& m : family.members) {
    CAPTURE(m.origins.front(), m.result.curve.cost, failures(m.result.certificate));
    CHECK(m.result.status == Status::certified);
    const double middle = m.result.path.u(1, m.result.path.u.cols() / 2);
    (middle > 0 ? one_side : other_side) = true;
  }
  CHECK(one_side);
  CHECK(other_side);
  // Mirror images are equally long; both of the shortest are there.
  CHECK(family.members[1].result.curve.cost == Approx(family.members[0].result.curve.cost).epsilon(1e-9));
}

TEST_CASE("graph routes of a sampled torus go around both sides of the hole", "[oracle]") {
  const auto torus = std::make_shared<const PointCloudManifold>(PointCloud(torus_cloud(3000), {}));
  const Problem problem = between(torus, make_euclidean_cost(3), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(-3, 0, 0));
  const Family family = by_routes(problem, 3, {});
  REQUIRE(family.members.size() >= 2);
  const auto [least, most] = std::minmax_element(
      family.members.begin(), family.members.end(),
      [](const FamilyMember& a, const FamilyMember& b) { return a.result.path.u(1, 30) < b.result.path.u(1, 30); });
  CHECK(least->result.path.u(1, 30) < 0);
  CHECK(most->result.path.u(1, 30) > 0);
}

}  // namespace leastcost::test
