// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a robot carries (`robot: {attached: ..}`), and what the files of a robot say besides: velocities, names, goals.
#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/problems/robots/attached.hpp>
#include <leastcost/urdf/urdf_robot.hpp>
#include "tests/app/config_text.hpp"
#include "tests/contracts/robot_contract.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::AngleAxisd;
using Eigen::Vector3d;
using Json = nlohmann::json;

const std::string kBox = "{id: crate, link: palm, type: box, size: [0.1, 0.06, 0.2], pose: {position: [0, 0, -0.2]}}";

std::string carrying_arm(const std::string& attached, const std::string& more = "") {
  return "manifold: robot\n"
         "robot: {type: urdf, file: gantry_arm.urdf, srdf: gantry_arm.srdf, group: arm, hold_state: open" +
         (attached.empty() ? "" : ", attached: [" + attached + "]") +
         "}\n"
         "obstacles: [{type: ball, center: [0, 0.05, 0.2], radius: 0.25}]\n"
         "clearance: 0.01\n"
         "cost: euclidean\n"
         "ends: {source: {state: left_bin}, target: {state: right_bin}}\n"
         "path: {points: 40}\n" +
         more;
}

std::filesystem::path attached_folder() { return project_dir() / "configs/data"; }

/// How near the crate comes to the middle of the ball, by transformations of Eigen.
double nearest_of_crate(const Points& path) {
  const Vector3d ball(0, 0.05, 0.2), half(0.05, 0.03, 0.1);
  double nearest = 1e300;
  for (Eigen::Index i = 0; i + 1 < path.cols(); ++i) {
    for (int k = 0; k <= 10; ++k) {
      const Eigen::VectorXd q = path.col(i) + (path.col(i + 1) - path.col(i)) * k / 10.0;
      const Eigen::Affine3d forearm = Eigen::Translation3d(q[0], 0, 1.05) * AngleAxisd(q[1], Vector3d::UnitY()) *
                                      Eigen::Translation3d(0, 0, -0.4) * AngleAxisd(0.3, Vector3d::UnitZ()) *
                                      AngleAxisd(q[2], Vector3d::UnitY());
      const Eigen::Affine3d crate = forearm * Eigen::Translation3d(0, 0, -0.32) * AngleAxisd(q[3], Vector3d::UnitZ()) *
                                    Eigen::Translation3d(0, 0, -0.08 - 0.2);
      nearest = std::min(nearest, ((crate.inverse() * ball).cwiseAbs() - half).cwiseMax(0).norm());
    }
  }
  return nearest;
}

std::set<std::pair<std::string, std::string>> named_pairs_of(const Robot& robot) {
  std::set<std::pair<std::string, std::string>> names;
  for (const auto& [i, j] : robot.self) {
    CHECK(robot.link(static_cast<std::size_t>(i)) != robot.link(static_cast<std::size_t>(j)));
    names.emplace(robot.part_name(static_cast<std::size_t>(i)), robot.part_name(static_cast<std::size_t>(j)));
  }
  return names;
}

std::shared_ptr<const Robot> carrying_gantry() {
  return make_urdf_robot({.file = "gantry_arm.urdf", .srdf = "gantry_arm.srdf", .group = "arm", .hold_state = "open"},
                         attached_folder());
}

}  // namespace

TEST_CASE("attached: a certified plan keeps the object clear of what the hand alone would pass") {
  const RunOutcome without = solve(parse_run(carrying_arm(""), "a.yaml", attached_folder()));
  CHECK(without.result.status == Status::certified);
  CHECK(nearest_of_crate(without.result.path.u) < 0.25);  // the crate would go through the ball
  const RunOutcome with = solve(parse_run(carrying_arm(kBox), "a.yaml", attached_folder()));
  CHECK(with.result.status == Status::certified);
  CHECK(nearest_of_crate(with.result.path.u) >= 0.25 + 0.01);
  CHECK(std::any_of(with.parts.notes.begin(), with.parts.notes.end(), [](const std::string& note) {
    return note.find("and to capsules that cover 'crate' and exceed it by at most") != std::string::npos;
  }));
}

TEST_CASE("attached: pairs of the robot keep their links, the object is apart from what it does not touch") {
  const std::shared_ptr<const Robot> robot = carrying_gantry();
  AttachedObject stick{.name = "stick", .link = "palm", .shape = {{{0, {0, 0, 0}, {0.3, 0, 0}, 0.02}}, 0}};
  const auto with = with_attached(*robot, {stick});
  CHECK(with->capsules.size() == robot->capsules.size() + 1);
  CHECK(std::is_sorted(with->capsules.begin(), with->capsules.end(),
                       [](const Capsule& a, const Capsule& b) { return a.link < b.link; }));
  const auto before = named_pairs_of(*robot), after = named_pairs_of(*with);
  CHECK(std::includes(after.begin(), after.end(), before.begin(), before.end()));
  CHECK(after.count({"beam", "stick"}) == 1);
  CHECK(after.count({"wrist", "stick"}) == 0);  // they do not move against each other
  stick.touches = {"beam", "slide"};
  const auto touching = named_pairs_of(*with_attached(*robot, {stick}));
  CHECK(touching.count({"beam", "stick"}) == 0);
  CHECK(touching.count({"slide", "stick"}) == 0);
  CHECK(touching.count({"upper_arm", "stick"}) == 1);
  check_robot(with);
}

TEST_CASE("attached: an end at which the object touches the robot is refused by their names, unless it may") {
  const std::string pole = "{id: pole, link: palm, type: capsule, from: [0, 0, 0], to: [0, 0, 1], radius: 0.02}";
  CHECK_THAT(refusal_of(carrying_arm(pole), attached_folder()), Contains("end_in_clearance") && Contains("pole"));
  const std::string may = replaced(pole, "radius: 0.02", "radius: 0.02, touches: [forearm, upper_arm, slide, beam]");
  CHECK(refusal_of(carrying_arm(may), attached_folder()) == "");
}

TEST_CASE("attached: what does not fit is named with its place") {
  const auto with = [](const std::string& from, const std::string& to) {
    return refusal_of(carrying_arm(replaced(kBox, from, to)), attached_folder());
  };
  CHECK_THAT(refusal_of(carrying_arm(kBox + ", " + kBox), attached_folder()),
             Contains("'id' in robot.attached[0]") && Contains("'crate' is given to two objects"));
  CHECK_THAT(with("0.1, 0.06, 0.2]", "1e300, 0.06, 0.2]"), Contains("none beyond 1e75"));
  CHECK(refusal_of(carrying_arm(kBox), attached_folder()) == "");
  CHECK_THAT(with("link: palm", "link: hand"), Contains("a.yaml:2") && Contains("has no link 'hand'; it has: beam"));
  CHECK_THAT(with("id: crate", "touches: [hand]"),
             Contains("a.yaml:2") && Contains("has no link 'hand'; it has: beam"));
  CHECK_THAT(with("size: [0.1, 0.06, 0.2]", "radius: 1"), Contains("radius") && Contains("not an option of this type"));
  CHECK_THAT(with(", size: [0.1, 0.06, 0.2]", ""), Contains("size") && Contains("is missing: a box has one"));
  CHECK_THAT(with("[0.1, 0.06, 0.2]", "[0.1, 0, 0.2]"), Contains("a.yaml:2"));
  CHECK_THAT(with("type: box", "type: bag"), Contains("must be one of: box, ball"));
  CHECK_THAT(with("type: box, size: [0.1, 0.06, 0.2]", "type: mesh, file: gone.obj"), Contains("gone.obj"));
}

TEST_CASE("attached: a mesh is covered by several capsules - the note says how far they exceed it") {
  const ScratchDir dir;
  {
    std::ofstream file(dir / "crate.obj");  // 0.1 x 0.06 x 0.2
    for (int i = 0; i < 8; ++i)
      file << "v " << ((i & 1) != 0 ? 0.05 : -0.05) << ' ' << ((i & 2) != 0 ? 0.03 : -0.03) << ' '
           << ((i & 4) != 0 ? 0.1 : -0.1) << '\n';
    file << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  }
  const std::string mesh = "type: mesh, file: " + (dir / "crate.obj").string();
  const Run run =
      parse_run(carrying_arm(replaced(kBox, "type: box, size: [0.1, 0.06, 0.2]", mesh)), "a.yaml", attached_folder());
  const Robot& robot = *run.parts.robot;
  CHECK(std::count(robot.owners.begin(), robot.owners.end(), "crate") > 1);
  CHECK_THAT(robot.whose, Contains("capsules that cover 'crate' and exceed it by at most "));
}

TEST_CASE("trajectory of a robot: velocities and names of its URDF - acceleration is asked for") {
  const std::string three = replaced(carrying_arm(""), "hold_state: open", "hold_state: open, hold: {roll: 0}");
  const Run run = parse_run(three + "output: {trajectory: {acceleration: 4}}\n", "a.yaml", attached_folder());
  REQUIRE(run.parts.trajectory.velocity.has_value());
  CHECK(*run.parts.trajectory.velocity == Vector3d(1, 2, 3));
  const ScratchDir dir;
  const std::filesystem::path out = write_run(solve(run), dir / "out");
  CHECK(Json::parse(content(out / "trajectory.json"))["joint_names"] == Json({"rail", "shoulder", "elbow"}));
  CHECK_THAT(refusal_of(three + "output: {trajectory: {velocity: 1}}\n", attached_folder()),
             Contains("a.yaml") && Contains("acceleration") && Contains("joint_limits.yaml"));
  CHECK_THAT(refusal_of(carrying_arm("", "output: {trajectory: {acceleration: [4]}}\n"), attached_folder()),
             Contains("none for the joint 'roll'"));
  CHECK(refusal_of(carrying_arm("", "output: {trajectory: {velocity: 1, acceleration: 4}}\n"), attached_folder()) ==
        "");
}

TEST_CASE("goals: the source among several is left out, alone it is refused") {
  const std::string source = "[-0.7, 0.3, -0.4, 0]";
  const auto to = [&](const std::string& rows) {
    return replaced(carrying_arm(""), "target: {state: right_bin}", "target: {points: [" + rows + "]}");
  };
  const Run run = parse_run(to(source + ", [0.7, -0.2, 0.3, 1.5]"), "a.yaml", attached_folder());
  CHECK(run.parts.problem.target.u.isApprox(Eigen::Vector4d(0.7, -0.2, 0.3, 1.5)));
  CHECK(run.parts.goals.empty());
  CHECK(std::any_of(run.parts.notes.begin(), run.parts.notes.end(), [](const std::string& note) {
    return note.find("the source itself is among the goals") != std::string::npos;
  }));
  CHECK_THAT(refusal_of(to(source + ", " + source), attached_folder()), Contains("is the same point as the source"));
}

}  // namespace leastcost::test
