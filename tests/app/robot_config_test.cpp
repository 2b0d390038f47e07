// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a configuration says about a robot, and what it is told where that does not fit.
#include <string>

#include <leastcost/framework/domain/checks_moves.hpp>
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

const std::string kBody = R"(manifold: {type: euclidean, dimension: 3}
cost: euclidean
ends:
  source: {point: [0, 0, 0]}
  target: {point: [4, 0, 0]}
robot: {type: rigid_body, shape: [[-0.5, 0, 0.5, 0, 0.1]]}
obstacles: [{type: ball, center: [2, 0.5], radius: 0.3}]
)";

const std::string kArm = R"(manifold:
  type: euclidean
  dimension: 7
  lower: [-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973]
  upper: [2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973]
cost: euclidean
ends:
  source: {point: [-1.2, 0.4, 0, -1.8, 0, 2.2, 0.7]}
  target: {point: [1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5]}
robot: {type: dh_arm, model: panda}
)";

}  // namespace

TEST_CASE("robot: it and its obstacles are read, and the first path is one that sees them") {
  CHECK(errors_of(kBody) == "");
  CHECK(errors_of(kArm) == "");  // against itself
  const LoadedConfig loaded = parse(kBody);
  CHECK(loaded.config.initializer.plugin->type == "rrt");
  CHECK(parse(kArm).config.initializer.plugin->type == "rrt");
  const LoadedConfig again = parse(resolved_yaml(loaded.config));
  CHECK(again.errors.render() == "");
  CHECK(resolved_yaml(again.config) == resolved_yaml(loaded.config));
}

TEST_CASE("robot: its obstacles are of the workspace, its domain of its configurations") {
  CHECK_THAT(errors_of(replaced(kBody, "[2, 0.5]", "[2, 0.5, 0]")),
             Contains("a.yaml:7:13") && Contains("has 3 dimensions, but the workspace of the robot has 2"));
  CHECK_THAT(errors_of(replaced(kBody, "dimension: 3", "dimension: 2").replace(0, 0, "")),
             Contains("has configurations of 3 coordinates, but the manifold has points of 2"));
  CHECK_THAT(errors_of(replaced(kArm, "[2.8973, 1.7628", "[2.8973, 2")),
             Contains("'robot': coordinate 1 has the limits [-1.7628, 1.7628], but the manifold extends beyond them"));
  CHECK_THAT(errors_of(replaced(kBody, "obstacles: [{type: ball, center: [2, 0.5], radius: 0.3}]\n", "")),
             Contains("'robot' has nothing to collide with: give 'obstacles'"));
  CHECK_THAT(errors_of(kArm + "clearance: 0.1\n"), Contains("needs obstacles, but there are none"));
}

TEST_CASE("robot: the manifold can be the box of its limits") {
  const std::string box = kArm.substr(0, kArm.find("cost:"));
  const std::string arm = replaced(kArm, box, "manifold: robot\n");
  CHECK(errors_of(arm) == "");
  LoadedConfig loaded = parse(arm), by_hand = parse(kArm);
  CHECK(loaded.config.initializer.plugin->type == by_hand.config.initializer.plugin->type);
  CHECK(loaded.config.solver.plugin->type == by_hand.config.solver.plugin->type);
  CHECK_THAT(errors_of(replaced(arm, "[-1.2, 0.4", "[-1.2, 4")), Contains("ends.source") || Contains("'point'"));
  CHECK_THAT(errors_of(replaced(arm, "robot: {type: dh_arm, model: panda}\n", "")),
             Contains("'robot' is the box of joint limits of a robot, but there is none"));
  CHECK_THAT(errors_of(replaced(kBody, "{type: euclidean, dimension: 3}", "robot")),
             Contains("a rigid body has no joints"));
  CHECK_THAT(errors_of(replaced(arm, "{point: [-1.2, 0.4, 0, -1.8, 0, 2.2, 0.7]}", "{state: home}")),
             Contains("the robot has no named states"));
  CHECK_THAT(errors_of(replaced(kBody, "{point: [0, 0, 0]}", "{point: [0, 0, 0], state: home}")),
             Contains("must have exactly one of"));
}

TEST_CASE("robot: its options are named where they are wrong") {
  CHECK_THAT(errors_of(replaced(kArm, "panda", "pandda")), Contains("unknown model 'pandda'") || Contains("'pandda'"));
  CHECK_THAT(errors_of(replaced(kBody, "0.5, 0, 0.1]]", "0.5, 0, -0.1]]")),
             Contains("'shape' in robot: capsule 0 must have a radius greater than 0"));
  CHECK_THAT(errors_of(replaced(kBody, "[2, 0.5]", "[0.2, 0.1]")),
             Contains("end_in_clearance: it is in collision: the body and the ball at (0.2, 0.1)") &&
                 Contains(" overlap by "));
}

TEST_CASE("robot: without a number of points it gets as many as its thin parts need") {
  CHECK_FALSE(parse(kBody).config.points);
  CHECK_FALSE(parse(kArm).config.points);
  CHECK(parse(kBody + "path: {points: 30}\n").config.points == 30);
  const LoadedConfig with_path = parse(kBody + "path: {cascade: true}\n");
  CHECK(with_path.errors.render() == "");
  CHECK_FALSE(with_path.config.points);
  CHECK(with_path.config.cascade);
  CHECK(parse(replaced(kBody, "robot: {type: rigid_body, shape: [[-0.5, 0, 0.5, 0, 0.1]]}\n", "")).config.points == 64);
}

}  // namespace leastcost::test
