// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Targets that are several goals, or a pose of a robot's tool.
#include <nlohmann/json.hpp>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

std::string among_discs(const std::string& target) {
  return "manifold: {type: euclidean, dimension: 2}\n"
         "cost: euclidean\n"
         "obstacles: [{type: ball, center: [1, 0], radius: 0.5}]\n"
         "ends: {source: {point: [0, 0]}, target: " +
         target + "}\n";
}

std::string arm(const std::string& target) {
  return "robot: {type: dh_arm, model: panda}\n"
         "manifold: robot\n"
         "cost: euclidean\n"
         "obstacles: [{type: ball, center: [0.6, 0, 0.6], radius: 0.1}]\n"
         "ends: {source: {point: [-1, 0.4, 0, -1.8, 0, 2.2, 0.7]}, target: " +
         target +
         "}\n"
         "path: {points: 30}\n";
}

Run parsed(const std::string& text) { return parse_run(text, "goals.yaml"); }

}  // namespace

TEST_CASE("goals: the path ends at the one that is cheapest to reach, not at the nearest") {
  const RunOutcome run = solve(parsed(among_discs("{points: [[1.6, 0], [-1.8, 0], [1, 0.2]]}")));
  REQUIRE(run.result.status == Status::certified);
  CHECK(run.parts.problem.target.u == Eigen::Vector2d(-1.8, 0));
  CHECK(run.parts.target.end.u == Eigen::Vector2d(-1.8, 0));
  CHECK(run.result.certificate.estimate.value == Approx(1.8));
  CHECK(run.family.size() == 2);  // the third one lies in the disc
  REQUIRE_FALSE(run.parts.notes.empty());
  CHECK_THAT(run.parts.notes.front(), Contains("goal 3 of the target was left out"));
}

TEST_CASE("goals: what is refused") {
  const auto refused = [](const std::string& target, const char* why) {
    CHECK_THROWS_WITH(parsed(among_discs(target)), Contains(why));
  };
  refused("{points: [[1, 0], [1, 0.2]]}", "none of them is free");
  refused("{points: [[1, 0, 0]]}", "must have 2 coordinates (x, y; found 3)");
  refused("{points: [[3, 0]], point: [1, 0]}", "exactly one of");
  refused("{tool: {position: [1, 0]}}", "needs a robot");
  CHECK_THROWS_WITH(parsed("manifold: {type: euclidean, dimension: 2}\ncost: euclidean\n"
                           "ends: {source: {points: [[1, 2]]}, target: {point: [0, 0]}}\n"),
                    Contains("only a target can have several goals"));
}

TEST_CASE("goals: where the source was refused the message is about the source alone") {
  for (const char* target : {"{tool: {position: [0.4, 0.3, 0.5]}}", "{points: [[0, 0, 0, -1, 0, 1, 0]]}"}) {
    std::string text = arm(target);
    text.replace(text.find("[-1, 0.4"), 3, "[-9");
    CHECK_THROWS_WITH(parsed(text), Contains("must have x0 between") && !Contains("ends.target"));
  }
}

TEST_CASE("ends: a target that is millions of turns away is refused with the angle that is meant") {
  const auto config = [](const std::string& target) {
    return "robot: {type: dh_arm, model: {type: table, rows: [[1, 0, 0, 0], [1, 0, 0, 0]], "
           "shape: [[2, -1, 0, 0, 0, 0, 0, 0.1]]}}\n"
           "manifold: robot\n"
           "cost: euclidean\n"
           "obstacles: [{type: ball, center: [0, 5, 0], radius: 0.1}]\n"
           "ends: {source: {point: [1, 0]}, target: " +
           target + "}\n";
  };
  const std::string why =
      "coordinate 0 is 1000000000, about 1.59e+08 turns from the source; at most 100 are allowed. The "
      "same position within half a turn of the source is 0.577395462";
  CHECK_THROWS_WITH(parsed(config("{point: [1e9, 0]}")), Contains(why));
  CHECK_THROWS_WITH(parsed(config("{points: [[1e9, 0], [2, 0]]}")), Contains(why));
  CHECK_THROWS_WITH(parsed(config("{point: [1e300, 0]}")), Contains("coordinate 0 is 1e+300, about 1.59e+299 turns"));
  CHECK(parsed(config("{point: [400, 0]}")).parts.problem.target.u[0] == 400);
}

TEST_CASE("goals: a pose of the tool of an arm") {
  const auto robot = make_dh_arm({});
  const Run run = parsed(arm("{tool: {position: [0.4, 0.3, 0.5], rpy: [3.14159265, 0, 0]}}"));
  const RunOutcome outcome = solve(run);
  CHECK(outcome.result.status == Status::certified);
  std::vector<Frame> links;
  robot->kinematics->place(outcome.parts.problem.target.u, links);
  CHECK((links.back().origin - Eigen::Vector3d(0.4, 0.3, 0.5)).norm() < 1e-7);
  CHECK((links.back().rotation.col(2) + Eigen::Vector3d::UnitZ()).norm() < 1e-6);
  for (const FamilyMember& member : outcome.family)
    CHECK(member.rank_cost >= outcome.family.front().rank_cost * (1 - 1e-9));
  const auto refused = [](const std::string& target, const char* why) {
    CHECK_THROWS_WITH(parsed(arm(target)), Contains(why));
  };
  refused("{tool: {position: [4, 0, 0]}}", "no configuration within the joint limits");
  refused("{tool: {link: elbow, position: [0.4, 0, 0.5]}}", "the robot has no link 'elbow'; it has: the base, link 1");
  refused("{tool: {position: [0.4, 0]}}", "must be 3 finite numbers");
  refused("{tool: {rpy: [0, 0, 0]}}", "must have a position");
}

}  // namespace leastcost::test
