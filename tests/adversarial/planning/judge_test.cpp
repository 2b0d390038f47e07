// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/adversarial/planning/judge/exact.hpp"
#include "tests/adversarial/planning/judge/grid_passage.hpp"
#include "tests/adversarial/planning/judge/tangent_graph.hpp"
#include "tests/adversarial/planning/scenes.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using judge::Place;
using judge::Scene;
using judge::Thing;

namespace {

const double kUlp = std::nextafter(1.0, 2.0) - 1;

Thing ball_at(const Place& center, double radius) { return {Thing::Kind::ball, radius, {center}}; }

}  // namespace

TEST_CASE("judge: the last digit decides") {
  const Thing ball = ball_at({0, 0}, 1);
  CHECK_FALSE(judge::comes_nearer(ball, 0, 0, {-1, 1}, {1, 1}));
  CHECK(judge::comes_nearer(ball, 0, 0, {-1, 1}, {1, 1 - kUlp / 2}));
  CHECK_FALSE(judge::comes_nearer(ball, 0, 1e-15, {-1, 1}, {1, 1 - kUlp / 2}));
  CHECK(judge::comes_nearer(ball, kUlp, 0, {-1, 1}, {1, 1}));
  // A Pythagorean triple: the line 3 x + 4 y = 25 touches the circle of radius 5 at (3, 4).
  CHECK_FALSE(judge::comes_nearer(ball_at({0, 0}, 5), 0, 0, {7, 1}, {-1, 7}));
  CHECK(judge::comes_nearer(ball_at({0, 0}, 5), 1e-300, 0, {7, 1}, {-1, 7}));

  const Thing box{Thing::Kind::box, 0, {{0, 0, 0}, {1, 1, 1}}};
  CHECK_FALSE(judge::comes_nearer(box, 0.5, 0, {-1, 1.5, 0.5}, {2, 1.5, 0.5}));
  CHECK(judge::comes_nearer(box, 0.5, 0, {-1, 1.5, 0.5}, {2, 1.5 - kUlp, 0.5}));
  CHECK(judge::comes_nearer(box, 1e-9, 0, {-1, 0.5, 0.5}, {2, 0.5, 0.5}));

  const Thing hook{Thing::Kind::polygon, 0, {{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {0, 1}}};
  CHECK_FALSE(judge::comes_nearer(hook, 0.5, 0, {0, 1.5}, {2.5, 1.5}));
  CHECK(judge::comes_nearer(hook, 0.5, 0, {0, 1.5}, {2.5 + 1e-15, 1.5}));
  CHECK(judge::comes_nearer(hook, 1e-9, 0, {0.5, 0.5}, {0.6, 0.5}));  // within
  CHECK(judge::comes_nearer(hook, 1e-9, 0, {2, 2}, {5, 2}));          // across
}

TEST_CASE("judge: shortest ways among discs that are known") {
  Scene scene;
  scene.source = {-2, 0}, scene.target = {2, 0};
  CHECK(judge::shortest_among_discs(scene).value() == 4);
  scene.things = {ball_at({0, 0}, 0.7)};
  scene.clearance = 0.3;
  const double around = 2 * std::sqrt(3.0) + std::numbers::pi / 3;
  CHECK(judge::shortest_among_discs(scene).value() == Approx(around).epsilon(1e-15));
  // From the circle to the circle: half of it.
  scene.source = {-1, 0}, scene.target = {1, 0};
  CHECK(judge::shortest_among_discs(scene).value() == Approx(std::numbers::pi).epsilon(1e-14));
  // Two discs with a gap between them, crossed by an inner tangent: above one and below the other.
  scene.source = {-4, 1}, scene.target = {4, -1};
  scene.things = {ball_at({-1.2, 0.1}, 0.7), ball_at({1.2, -0.1}, 0.7)};
  const double both = judge::shortest_among_discs(scene).value();
  CHECK(both > std::hypot(8, 2));
  // A ring of discs around the source has no way out.
  scene.source = {0, 0};
  scene.things.clear();
  for (int i = 0; i < 12; ++i) {
    const double angle = std::numbers::pi * i / 6;
    scene.things.push_back(ball_at({2 * std::cos(angle), 2 * std::sin(angle)}, 0.4));
  }
  CHECK_FALSE(judge::shortest_among_discs(scene).has_value());
  CHECK_FALSE(judge::grid_confirms(scene, 200));
  scene.clearance = 0;
  CHECK(judge::shortest_among_discs(scene).value() == Approx(std::hypot(4, 1)).epsilon(0.05));
  CHECK(judge::grid_confirms(scene, 200));
}

TEST_CASE("judge: scenes go through text bit for bit") {
  for (const SceneFamily& family : scene_families()) {
    CAPTURE(family.name);
    const Scene scene = family.make(7).scene;
    std::stringstream text;
    judge::write(scene, text);
    const Scene again = judge::read_scene(text);
    CHECK(again.source == scene.source);
    CHECK(again.target == scene.target);
    CHECK(again.clearance == scene.clearance);
    REQUIRE(again.things.size() == scene.things.size());
    for (std::size_t i = 0; i < scene.things.size(); ++i) {
      CHECK(again.things[i].corners == scene.things[i].corners);
      CHECK(again.things[i].radius == scene.things[i].radius);
    }
  }
}

}  // namespace leastcost::test
