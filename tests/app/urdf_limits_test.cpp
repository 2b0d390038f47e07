// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Limits of a robot's files: of joints that mimic others, of a joint_limits.yaml; and links of an SRDF that are not
// there.
#include <fstream>
#include <string>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/problems/robots/robot.hpp>
#include <leastcost/urdf/urdf_robot.hpp>
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

/// Two fingers: the second does `mimics`, within `limits`; `first` are those of the first one.
std::string fingers(const std::string& mimics, const std::string& limits,
                    const std::string& first = "lower='-1' upper='2'") {
  std::string text = "<robot name='r'>\n<link name='palm'/>\n";
  for (const std::string name : {"a", "b"})
    text += "<link name='" + name + "'><collision><geometry><sphere radius='0.1'/></geometry></collision></link>\n";
  text += "<joint name='first' type='prismatic'><parent link='palm'/><child link='a'/><limit " + first +
          " velocity='2'/></joint>\n<joint name='second' type='revolute'><parent link='palm'/><child link='b'/>"
          "<origin xyz='0 5 0'/>"
          "<mimic joint='first' " +
          mimics + "/>" + limits + "</joint>\n</robot>\n";
  return text;
}

struct Read {
  std::shared_ptr<const Robot> robot;
  std::vector<std::string> notes;
  std::string refusal;
  double lower() const { return robot->kinematics->lower()[0]; }
  double upper() const { return robot->kinematics->upper()[0]; }
};

Read read(const std::string& urdf, const std::string& srdf = "", UrdfRobotOptions options = {}) {
  const ScratchDir folder;
  std::ofstream(folder / "robot.urdf") << urdf;
  options.file = "robot.urdf";
  if (!srdf.empty()) {
    std::ofstream(folder / "robot.srdf") << srdf;
    options.srdf = "robot.srdf";
  }
  Read out;
  try {
    out.robot =
        make_urdf_robot(options, folder.path(), [&](std::string note) { out.notes.push_back(std::move(note)); });
  } catch (const Error& error) {
    out.refusal = error.what();
  }
  return out;
}

/// A robot of two joints that moves among nothing, with this file of limits.
std::string limited(const std::string& trajectory) {
  return "manifold: robot\nrobot: {type: urdf, file: robot.urdf}\ncost: euclidean\n"
         "ends: {source: {point: [0, 0]}, target: {point: [1, 0.5]}}\noutput: {trajectory: " +
         trajectory + "}\n";
}

}  // namespace

TEST_CASE("urdf: a joint goes no farther than those that mimic it can follow") {
  const auto range = [](const std::string& mimics, const std::string& limits) {
    const Read found = read(fingers(mimics, limits));
    CAPTURE(found.refusal);
    REQUIRE(found.robot != nullptr);
    return std::pair(found.lower(), found.upper());
  };
  CHECK(range("", "<limit lower='-0.5' upper='1'/>") == std::pair(-0.5, 1.0));
  CHECK(range("multiplier='2' offset='1'", "<limit lower='0' upper='9'/>") == std::pair(-0.5, 2.0));
  CHECK(range("multiplier='-1'", "<limit lower='-1.5' upper='0.5'/>") == std::pair(-0.5, 1.5));
  CHECK(range("multiplier='-2' offset='1'", "<limit lower='-1' upper='9'/>") == std::pair(-1.0, 1.0));
  // What allows more, or says nothing, cuts nothing.
  for (const char* limits :
       {"<limit lower='-9' upper='9'/>", "<limit lower='0' upper='0'/>", "<limit velocity='3'/>", ""})
    CHECK(range("", limits) == std::pair(-1.0, 2.0));
  CHECK(range("multiplier='0' offset='0.5'", "<limit lower='0' upper='1'/>") == std::pair(-1.0, 2.0));
  // A third one that mimics the second follows the first.
  std::string chain = fingers("multiplier='2'", "");
  chain =
      replaced(chain, "</robot>",
               "<link name='c'/><joint name='third' type='prismatic'><parent link='palm'/><child link='c'/>"
               "<mimic joint='second' multiplier='0.5' offset='0.25'/><limit lower='0' upper='1'/></joint></robot>");
  CHECK(read(chain).lower() == -0.25);
  CHECK(read(chain).upper() == 0.75);
  // Also one without limits of its own.
  const Read endless =
      read(replaced(replaced(fingers("", "<limit lower='-3' upper='4'/>"), "'prismatic'", "'continuous'"),
                    "<limit lower='-1' upper='2' velocity='2'/>", ""));
  REQUIRE(endless.robot != nullptr);
  CHECK(endless.lower() == -3);
  CHECK(endless.upper() == 4);
}

TEST_CASE("urdf: a range that is cut is noted, and none that is empty is taken") {
  const Read cut = read(fingers("multiplier='-1'", "<limit lower='-1.5' upper='0.5'/>"));
  REQUIRE(cut.notes.size() == 1);
  CHECK_THAT(cut.notes[0],
             Contains("robot.urdf:6: joint 'first' is limited to -0.5 to 1.5 (its own limits are -1 to 2), "
                      "because 'second' mimics it"));
  CHECK(read(fingers("", "<limit lower='-9' upper='9'/>")).notes.empty());
  CHECK_THAT(
      read(fingers("", "<limit lower='3' upper='4'/>")).refusal,
      Contains("robot.urdf:6: the joint 'second' mimics 'first': the limits of 'first' leave no value at which"));
  CHECK_THAT(
      read(fingers("multiplier='0' offset='5'", "<limit lower='0' upper='1'/>")).refusal,
      Contains("robot.urdf:6: the joint 'second' always stands at its offset") && Contains("5 is outside its limits"));
  CHECK_THAT(read(fingers("", "<limit lower='1' upper='-1'/>")).refusal,
             Contains("'lower' of the joint 'second' is above its 'upper'"));
  // The soft limits of both hold.
  const Read soft = read(fingers("",
                                 "<limit lower='-0.5' upper='1'/><safety_controller soft_lower_limit='-0.25' "
                                 "soft_upper_limit='0.75'/>"));
  CHECK(soft.lower() == -0.25);
  CHECK(soft.upper() == 0.75);
  UrdfRobotOptions hard;
  hard.soft_limits = false;
  CHECK(read(fingers("",
                     "<limit lower='-0.5' upper='1'/><safety_controller soft_lower_limit='-0.25' "
                     "soft_upper_limit='0.75'/>"),
             "", hard)
            .lower() == -0.5);
}

TEST_CASE("srdf: pairs of links that the robot does not have are noted") {
  const std::string urdf = fingers("", "");
  const auto notes = [&](const std::string& pairs) {
    const Read found = read(urdf, "<robot name='r'>\n" + pairs + "</robot>");
    CAPTURE(found.refusal);
    REQUIRE(found.robot != nullptr);
    return found.notes;
  };
  CHECK(notes("<disable_collisions link1='a' link2='b'/>\n").empty());
  const auto one = notes("<disable_collisions link1='a' link2='palm'/>\n<disable_collisions link1='a' link2='bb'/>\n");
  REQUIRE(one.size() == 1);
  CHECK_THAT(one[0], Contains("robot.srdf:3: <disable_collisions> names links that ") &&
                         Contains("robot.urdf does not have ('bb'); it is ignored"));
  const auto more = notes("<enable_collisions link1='tool' link2='b'/>\n<disable_default_collisions link='hook'/>\n");
  REQUIRE(more.size() == 1);
  CHECK_THAT(more[0], Contains("robot.srdf:2: <enable_collisions>") || Contains("robot.srdf:3"));
  CHECK_THAT(more[0], Contains("does not have ('hook', 'tool'); 2 such elements are ignored"));
}

TEST_CASE("trajectory: limits come from a joint_limits.yaml of MoveIt") {
  const ScratchDir folder;
  std::string urdf = fingers("", "");
  urdf = replaced(urdf, "<mimic joint='first' />", "<limit lower='-1' upper='1' velocity='4'/>");
  std::ofstream(folder / "robot.urdf") << urdf;
  const auto limits = [&](const std::string& text) { std::ofstream(folder / "joint_limits.yaml") << text; };
  const std::string both =
      "joint_limits:\n  first:\n    has_velocity_limits: true\n    max_velocity: 1.5\n    has_acceleration_limits: "
      "true\n"
      "    max_acceleration: 3\n  second:\n    has_velocity_limits: false\n    max_velocity: 0\n"
      "    has_acceleration_limits: true\n    max_acceleration: 5\n  gripper: {has_velocity_limits: false}\n";
  limits(both);
  const auto run = [&](const std::string& trajectory) {
    return parse_run(limited(trajectory), "a.yaml", folder.path());
  };
  const TrajectoryOptions found = run("{limits: joint_limits.yaml}").parts.trajectory;
  REQUIRE((found.velocity.has_value() && found.acceleration.has_value()));
  CHECK(*found.velocity == Eigen::Vector2d(1.5, 4));  // that of the URDF where the file has none
  CHECK(*found.acceleration == Eigen::Vector2d(3, 5));
  const RunOutcome outcome = solve(run("{limits: joint_limits.yaml}"));
  REQUIRE(outcome.trajectory.has_value());
  CHECK(outcome.trajectory->velocity.row(0).cwiseAbs().maxCoeff() <= 1.5);
  CHECK(outcome.trajectory->acceleration.row(0).cwiseAbs().maxCoeff() == Approx(3));
  // What is given goes first.
  CHECK(*run("{limits: joint_limits.yaml, velocity: 0.5}").parts.trajectory.velocity ==
        Eigen::VectorXd::Constant(1, 0.5));
  // Speeds are scaled as MoveIt scales them, and that is said.
  limits("default_velocity_scaling_factor: 0.1\ndefault_acceleration_scaling_factor: 0.5\n" + both);
  const Run scaled = run("{limits: joint_limits.yaml}");
  CHECK(scaled.parts.trajectory.velocity->isApprox(Eigen::Vector2d(0.15, 0.4)));
  CHECK(scaled.parts.trajectory.acceleration->isApprox(Eigen::Vector2d(1.5, 2.5)));
  std::string notes;
  for (const std::string& note : scaled.parts.notes) notes += note + "\n";
  CHECK_THAT(notes, Contains("limits of velocity are 0.1 of those in joint_limits.yaml, by its "
                             "default_velocity_scaling_factor"));
  // Under a name of ROS 2, and in a domain that was written out.
  std::string inner = "robot_description_planning:\n  " + both;
  for (std::size_t at = inner.find('\n', 30); at + 1 < inner.size(); at = inner.find('\n', at + 1))
    inner.insert(at + 1, "  ");
  limits(inner);
  CHECK(*run("{limits: joint_limits.yaml}").parts.trajectory.acceleration == Eigen::Vector2d(3, 5));
  const std::string box = replaced(limited("{limits: joint_limits.yaml}"), "manifold: robot",
                                   "manifold: {type: euclidean, dimension: 2, lower: [-1, -1], upper: [2, 1]}");
  CHECK(*parse_run(box, "a.yaml", folder.path()).parts.trajectory.acceleration == Eigen::Vector2d(3, 5));
}

TEST_CASE("trajectory: a joint_limits.yaml that does not fit is refused with its lines") {
  const ScratchDir folder;
  std::ofstream(folder / "robot.urdf") << replaced(fingers("", ""), "<mimic joint='first' />",
                                                   "<limit lower='-1' upper='1'/>");
  const auto refused = [&](const std::string& text) {
    std::ofstream(folder / "joint_limits.yaml") << text;
    return refusal_of(limited("{limits: joint_limits.yaml}"), folder.path());
  };
  const std::string good =
      "{has_velocity_limits: true, max_velocity: 1, has_acceleration_limits: true, max_acceleration: 2}\n";
  CHECK(refused("joint_limits:\n  first: " + good + "  second: " + good) == "");
  CHECK_THAT(
      refused("joint_limits:\n  first: " + good + "  secnd: " + good),
      Contains("a.yaml:5") && Contains("joint_limits.yaml and the robot's file have none for the joint 'second'"));
  CHECK_THAT(refused("joint_limits:\n  third: " + good),
             Contains("has none of the robot's joints, which are first, second"));
  CHECK_THAT(refused("joint_limits:\n  first: " + replaced(good, "max_velocity: 1", "max_velocity: 0")),
             Contains("joint_limits.yaml:2") && Contains("must be greater than 0"));
  CHECK_THAT(refused("joint_limits:\n  first: " + replaced(good, "max_velocity: 1, ", "")),
             Contains("joint_limits.yaml:2") && Contains("missing key 'max_velocity' in the joint 'first'"));
  CHECK_THAT(refused("joint_limits:\n  first: " + replaced(good, "max_velocity", "max_velocty")),
             Contains("joint_limits.yaml:2") && Contains("max_velocty"));
  CHECK_THAT(refused("limits: 3\n"), Contains("joint_limits.yaml:1") && Contains("missing key 'joint_limits'"));
  CHECK_THAT(refused("joint_limits: [1, 2]\n"), Contains("joint_limits.yaml:1"));
  CHECK_THAT(refused("default_velocity_scaling_factor: 2\njoint_limits:\n  first: " + good),
             Contains("joint_limits.yaml:1") && Contains("at most 1"));
  CHECK_THAT(refused(""), Contains("joint_limits.yaml"));
  CHECK_THAT(refusal_of(limited("{limits: gone.yaml}"), folder.path()), Contains("gone.yaml"));
  CHECK_THAT(refusal_of(kPlane + "output: {trajectory: {limits: joint_limits.yaml}}\n", folder.path()),
             Contains("a.yaml:6") && Contains("there is no robot"));
}

}  // namespace leastcost::test
