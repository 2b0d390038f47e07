// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cstdlib>

#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include "tests/adversarial/planning/judge/tangent_graph.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

/// Two discs between the ends, which may overlap.
judge::Scene two_discs(Random& random) {
  judge::Scene scene;
  scene.source = {-1.6, random.uniform(-0.3, 0.3)};
  scene.target = {1.6, random.uniform(-0.3, 0.3)};
  for (const double x : {-0.6, 0.6})
    scene.things.push_back({judge::Thing::Kind::ball,
                            random.uniform(0.2, 0.7),
                            {{x + random.uniform(-0.2, 0.2), random.uniform(-0.6, 0.6)}}});
  return scene;
}

Problem among_discs(const judge::Scene& scene) {
  const auto place = [](const judge::Place& x) { return Vector2d(x[0], x[1]); };
  Problem problem =
      between(box(Vector2d(-2, -2), Vector2d(2, 2)), make_euclidean_cost(2), place(scene.source), place(scene.target));
  FreeSpace::Obstacles discs;
  for (const judge::Thing& disc : scene.things)
    discs.push_back(make_ball({.center = place(disc.corners.front()), .radius = disc.radius}));
  problem.manifold = std::make_shared<FreeSpace>(problem.manifold, std::move(discs), 0);
  return problem;
}

/// From above or below both discs (`side`).
Result bracket_from(double side, const judge::Scene& scene) {
  Points over(2, 3);
  over << -0.8, 0, 0.8, side, side, side;
  FindOptions options;
  options.points = 60;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 1e-2})};
  return find_path(among_discs(scene), WaypointsInitializer(over), Newton(), options);
}

constexpr double kOfChain = 2e-3;  // a chain of so many points is dearer than the curve by less

}  // namespace

/// The bound is below the length of the shortest path, and from whichever side the search began that one's class is
/// delivered, where the gap tells it from others. LEASTCOST_BRACKET_PROBLEMS sets another number of scenes.
TEST_CASE("bracket: among two discs the shortest way is delivered") {
  const char* text = std::getenv("LEASTCOST_BRACKET_PROBLEMS");  // NOLINT(concurrency-mt-unsafe)
  const int scenes = text == nullptr ? 3 : std::atoi(text);
  Random random;
  int proved = 0, shortest = 0;
  for (int k = 0; k < scenes; ++k) {
    CAPTURE(k);
    const judge::Scene scene = two_discs(random);
    const double least = judge::shortest_among_discs(scene).value();
    for (const double side : {-1.5, 1.5}) {
      const Result result = bracket_from(side, scene);
      const GlobalBound& bound = result.certificate.global.value();
      CHECK(bound.lower_bound <= least * (1 + 1e-12));
      CHECK(bound.lower_bound > 0.9 * least);
      CHECK(result.curve.cost >= least * (1 - 1e-9));
      if (!bound.proved) continue;
      ++proved;
      CHECK(result.curve.cost <= least / (1 - bound.gap) * (1 + 1e-12));
      if (result.curve.cost <= least * (1 + kOfChain)) ++shortest;
    }
  }
  if (scenes > 3) WARN(proved << " of " << 2 * scenes << " proved, " << shortest << " of them the shortest");
  CHECK(proved >= scenes);
}

/// The chain on the wrong side is fitted to margins that leave no room: they say nothing of the way that is found then.
TEST_CASE("bracket: the better way is not placed between walls that the other chain had moved") {
  judge::Scene scene;
  scene.source = {-1.6, 0.23457731668609422};
  scene.target = {1.6, -0.11023189579029449};
  scene.things = {{judge::Thing::Kind::ball, 0.67527112601493167, {{-0.53643387584971314, 0.43575060588133419}}},
                  {judge::Thing::Kind::ball, 0.64335647560145204, {{0.46240947660822446, -0.22330450140620367}}}};
  for (const double side : {-1.5, 1.5})
    CHECK(bracket_from(side, scene).curve.cost <= judge::shortest_among_discs(scene).value() * (1 + kOfChain));
}

}  // namespace leastcost::test
