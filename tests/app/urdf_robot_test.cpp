// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/urdf/urdf_robot.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/refused_key.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Translation3d;
using Eigen::Vector3d;
using RobotPtr = std::shared_ptr<const Robot>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RobotPtr gantry_arm(UrdfRobotOptions options = {}) {
  options.file = "gantry_arm.urdf";
  options.srdf = "gantry_arm.srdf";
  return make_urdf_robot(options, project_dir() / "configs/data");
}

/// A file in a folder of its own, and the robot of it.
class Written {
 public:
  explicit Written(const std::string& urdf, const std::string& srdf = "") {
    std::ofstream(folder_ / "robot.urdf") << urdf;
    options.file = "robot.urdf";
    if (srdf.empty()) return;
    std::ofstream(folder_ / "robot.srdf") << srdf;
    options.srdf = "robot.srdf";
  }
  RobotPtr robot() const { return make_urdf_robot(options, folder_.path()); }
  std::filesystem::path path() const { return folder_.path(); }
  /// What it is refused with, without the folder.
  std::string message() const {
    try {
      robot();
    } catch (const Error& error) {
      std::string text = error.what();
      if (text.rfind(folder_.path().string(), 0) == 0) text = text.substr(folder_.path().string().size() + 1);
      return text;
    }
    return "";
  }

  UrdfRobotOptions options;

 private:
  ScratchDir folder_;
};

const std::string kLinks = R"(<robot name="r">
<link name="a"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
<link name="b"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
)";

/// Two links and what else stands in the file.
std::string with(const std::string& more) { return kLinks + more + "</robot>\n"; }

const std::string kHinge =
    R"(<joint name="j" type="revolute"><parent link="a"/><child link="b"/><limit lower="-1" upper="1"/></joint>
)";

Affine3d affine(const Frame& frame) {
  Affine3d out = Affine3d::Identity();
  out.linear() = frame.rotation;
  out.translation() = frame.origin;
  return out;
}

Affine3d rpy(double roll, double pitch, double yaw) {
  return Affine3d(AngleAxisd(yaw, Vector3d::UnitZ()) * AngleAxisd(pitch, Vector3d::UnitY()) *
                  AngleAxisd(roll, Vector3d::UnitX()));
}

Affine3d moved(double x, double y, double z) { return Affine3d(Translation3d(x, y, z)); }

int link_named(const Kinematics& kinematics, const std::string& name) {
  for (int link = 0; link < kinematics.link_count(); ++link)
    if (kinematics.link_name(link) == name) return link;
  return -1;
}

std::set<std::string> pairs_of(const Robot& robot) {
  std::set<std::string> names;
  for (const auto& [i, j] : robot.self)
    names.insert(robot.kinematics->link_name(robot.capsules[static_cast<std::size_t>(i)].link) + " " +
                 robot.kinematics->link_name(robot.capsules[static_cast<std::size_t>(j)].link));
  return names;
}

}  // namespace

TEST_CASE("urdf: links are where the joints of the file put them") {
  const RobotPtr robot = gantry_arm();
  const Kinematics& kinematics = *robot->kinematics;
  REQUIRE(kinematics.dimension() == 5);  // the second finger mimics the first
  CHECK(kinematics.lower()[1] == -1.9);  // the soft limit
  CHECK(kinematics.lower()[3] == -kInfinity);
  CHECK(kinematics.upper()[4] == 0.05);
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Frame> links;
  for (int trial = 0; trial < 50; ++trial) {
    Eigen::VectorXd q(5);
    for (int i = 0; i < 5; ++i) q[i] = 2 * unit(engine) - 1;
    q[4] = 0.05 * unit(engine);
    kinematics.place(q, links);
    const auto is_at = [&](const char* name, const Affine3d& place) {
      const int link = link_named(kinematics, name);
      REQUIRE(link >= 0);
      CHECK((affine(links[static_cast<std::size_t>(link)]).matrix() - place.matrix()).norm() < 1e-12);
    };
    const Affine3d slide = moved(q[0], 0, 1.15);
    const Affine3d upper = slide * moved(0, 0, -0.1) * AngleAxisd(q[1], Vector3d::UnitY());
    const Affine3d forearm = upper * moved(0, 0, -0.4) * rpy(0, 0, 0.3) * AngleAxisd(q[2], Vector3d::UnitY());
    const Affine3d wrist = forearm * moved(0, 0, -0.32) * AngleAxisd(q[3], Vector3d::UnitZ());
    is_at("slide", slide);
    is_at("upper_arm", upper);
    is_at("forearm", forearm);
    is_at("wrist", wrist);
    is_at("left_finger", wrist * moved(-0.01 - q[4], 0, -0.11));
    is_at("right_finger", wrist * moved(0.01 + q[4], 0, -0.11));
  }
  CHECK(link_named(kinematics, "palm") == -1);  // it is one with the wrist
}

TEST_CASE("urdf: a group moves and the others are held") {
  UrdfRobotOptions options;
  options.group = "arm";
  const RobotPtr arm = gantry_arm(options);
  CHECK(arm->kinematics->dimension() == 4);
  CHECK(arm->kinematics->link_count() == 5);
  REQUIRE(arm->states.size() == 2);
  CHECK(arm->states.at("left_bin").isApprox(Eigen::Vector4d(-0.7, 0.3, -0.4, 0)));
  options.hold_state = "open";
  const RobotPtr open = gantry_arm(options);
  options.hold_state = "";
  options.hold = {{"left", 0.04}};
  const RobotPtr held = gantry_arm(options);
  REQUIRE(open->capsules.size() == arm->capsules.size());
  double apart = 0;
  for (std::size_t i = 0; i < open->capsules.size(); ++i) {
    CHECK(open->capsules[i].from == held->capsules[i].from);
    apart = std::max(apart, (open->capsules[i].from - arm->capsules[i].from).norm());
  }
  CHECK(apart == Approx(0.04));
  options.hold = {};
  options.group = "all";
  CHECK(gantry_arm(options)->kinematics->dimension() == 5);
  CHECK(gantry_arm(options)->states.empty());  // none speaks of all joints
  options.soft_limits = false;
  CHECK(gantry_arm(options)->kinematics->upper()[1] == 2);
  options.position = Vector3d(1, 2, 3);
  options.rpy = Vector3d(0.1, 0.2, 0.3);
  std::vector<Frame> links;
  gantry_arm(options)->kinematics->place(Eigen::VectorXd::Zero(5), links);
  CHECK((affine(links[0]).matrix() - (moved(1, 2, 3) * rpy(0.1, 0.2, 0.3)).matrix()).norm() < 1e-14);
}

TEST_CASE("urdf: pairs are those that the SRDF leaves or without one those that are no neighbours") {
  UrdfRobotOptions options;
  options.group = "arm";
  const std::set<std::string> pairs = pairs_of(*gantry_arm(options));
  CHECK(pairs.count("beam upper_arm") == 1);
  CHECK(pairs.count("beam slide") == 0);     // disabled
  CHECK(pairs.count("forearm wrist") == 1);  // the fingers, which are one with the wrist
  options = {};
  options.file = "gantry_arm.urdf";
  const std::set<std::string> all = pairs_of(*make_urdf_robot(options, project_dir() / "configs/data"));
  CHECK(all.count("forearm wrist") == 0);
  CHECK(all.count("upper_arm wrist") == 1);
  CHECK(all.count("left_finger right_finger") == 1);  // both move
  CHECK(gantry_arm({})->whose.find("exceed them by at most") != std::string::npos);
}

TEST_CASE("urdf: parts that always touch each other are left out and named") {
  const std::string far =
      "<link name='c'><collision><geometry><sphere radius='0.05'/></geometry></collision></link>\n"
      "<joint name='k' type='revolute'><parent link='b'/><child link='c'/><origin xyz='0 0.16 0'/>\n"
      "<axis xyz='0 0 1'/><limit lower='-1' upper='1'/></joint>\n";
  const RobotPtr robot = Written(with(kHinge + far), "<robot name='r'/>").robot();
  CHECK(pairs_of(*robot) == std::set<std::string>{"a c", "b c"});  // 10 mm apart, always
  CHECK_THAT(robot->whose, Contains("pairs of parts that touch in every configuration tried are ignored: a and b"));
}

TEST_CASE("urdf: wrong files are refused with their line") {
  CHECK(Written(with(kHinge)).message() == "");
  CHECK(Written("").message() == "robot.urdf:1: not XML: there is no element");
  CHECK_THAT(Written("<robot>\n<link name='a'>\n</robot>").message(),
             Contains("robot.urdf:2: not XML: an element is not closed by its own name"));
  CHECK_THAT(Written("hello").message(), Contains("robot.urdf:1: not XML"));
  CHECK(Written("\n<sdf/>").message() == "robot.urdf:2: must have <robot> as its outermost element");
  CHECK(Written("<robot name='r'/>").message() == "robot.urdf:1: <robot> must have a <link>");
  CHECK_THAT(Written("<robot>\n<xacro:include filename='x'/></robot>").message(),
             Contains("robot.urdf:2: this is a xacro file"));
  CHECK(Written(with("")).message() ==
        "robot.urdf:1: the links 'a' and 'b' are both the child of no joint; a robot has one root: join them");
  const auto joint = [](const std::string& type, const std::string& inner) {
    return Written(with("<joint name=\"j\" type=\"" + type + "\">\n" + inner + "\n</joint>\n")).message();
  };
  const std::string links = "<parent link='a'/><child link='b'/>";
  CHECK(joint("revolute", links) ==
        "robot.urdf:4: the revolute joint 'j' has no limits: give <limit lower=\"..\" "
        "upper=\"..\"/>, or make it continuous");
  CHECK_THAT(joint("prismatic", links + "<limit effort='1'/>"), Contains("the prismatic joint 'j' has no limits"));
  CHECK_THAT(joint("revolute", links + "<limit lower='1' upper='0'/>"), Contains("robot.urdf:5: 'lower' of the joint"));
  CHECK(joint("continuous", "<parent link='c'/><child link='b'/>") ==
        "robot.urdf:5: the parent 'c' of the joint 'j' is not a link of this file");
  CHECK_THAT(joint("continuous", "<child link='b'/>"), Contains("robot.urdf:4: the joint 'j' has no <parent>"));
  CHECK(joint("continuous", links + "<axis xyz='0 0 0'/>") == "robot.urdf:5: the axis of the joint 'j' is zero");
  CHECK(joint("continuous", links + "<origin xyz='0 nan 0'/>") ==
        "robot.urdf:5: 'xyz' of <origin> must be 3 finite numbers, not '0 nan 0'");
  CHECK_THAT(joint("continuous", links + "<origin xyz='0 1e999 0'/>"), Contains("3 finite numbers"));
  CHECK_THAT(joint("continuous", links + "<origin xyz='0 1'/>"), Contains("3 finite numbers, not '0 1'"));
  CHECK_THAT(joint("continuous", links + "<origin xyz='0 1 2x'/>"), Contains("3 finite numbers"));
  CHECK_THAT(joint("screw", links), Contains("'screw' is not a known type of joint"));
  CHECK_THAT(joint("floating", links), Contains("the joint 'j' is floating"));
  CHECK_THAT(joint("fixed", links), Contains("no joint of it moves"));
  CHECK_THAT(Written("<robot name='r'><link name='a'><collision><geometry><sphere radius='1'/></geometry></collision>"
                     "</link><link name='b'/>" +
                     kHinge + "</robot>")
                 .message(),
             Contains("no moving link has a collision shape"));
  CHECK_THAT(joint("continuous", links + "<mimic joint='j'/>"), Contains("mimics 'j', and so on in a loop"));
  const std::string loop =
      "<link name='c'/>\n<joint name='k' type='continuous'><parent link='a'/><child link='b'/><mimic "
      "joint='m'/></joint>\n"
      "<joint name='m' type='continuous'><parent link='b'/><child link='c'/><mimic joint='k'/></joint>\n";
  CHECK_THAT(Written(with(loop)).message(),
             Contains("robot.urdf:5: the joint 'k' mimics 'm', and so on in a loop: one of them must move by itself"));
  CHECK_THAT(joint("continuous", links + "<mimic joint='x'/>"),
             Contains("mimics 'x', which is not a joint that moves"));
  CHECK_THAT(joint("continuous", "<parent link='a'/><child link='c'/>"),
             Contains("robot.urdf:5: the child 'c' of the joint 'j' is not a link of this file"));
  CHECK_THAT(Written(with(kHinge + kHinge)).message(), Contains("a second joint 'j'") || Contains("one parent"));
  const std::string back = "<joint name='k' type='continuous'><parent link='b'/><child link='a'/></joint>\n";
  CHECK(Written(with(kHinge + back)).message() ==
        "robot.urdf:1: every link is the child of a joint: the joints are in a cycle");
  CHECK(Written(with("<link name='c'/>\n" + kHinge + back)).message() ==
        "robot.urdf:5: the joint 'j' is in a cycle of joints");
  const auto shape = [](const std::string& geometry) {
    return Written("<robot name='r'><link name='a'>\n<collision><geometry>" + geometry +
                   "</geometry></collision></link></robot>")
        .message();
  };
  CHECK(shape("<sphere radius='0'/>") == "robot.urdf:2: 'radius' of <sphere> must be greater than 0");
  CHECK_THAT(shape("<sphere/>"), Contains("robot.urdf:2: <sphere> must have the attribute 'radius'"));
  CHECK_THAT(shape("<box size='1 1 -1'/>"), Contains("robot.urdf:2: 'size' of <box>"));
  CHECK_THAT(shape("<cone/>"), Contains("robot.urdf:2: <cone> is not a known shape"));
  CHECK_THAT(shape(""), Contains("robot.urdf:2: <collision> must have a <geometry> with one shape"));
  Written huge(with(kHinge));
  std::filesystem::resize_file(huge.path() / "robot.urdf", std::uintmax_t(65) << 20);
  CHECK(huge.message() == "robot.urdf is 65 MB; the limit is 64 MB");
}

TEST_CASE("urdf: options that do not fit the files are refused by their keys") {
  const auto key = [](const auto& change) {
    UrdfRobotOptions options;
    change(options);
    return refused_key([&] { gantry_arm(options); });
  };
  using O = UrdfRobotOptions;
  CHECK(key([](O&) {}) == "");
  CHECK(key([](O& o) { o.group = "leg"; }) == "group");
  CHECK(key([](O& o) { o.hold = {{"right", 0}}; }) == "hold");
  CHECK(key([](O& o) { o.hold = {{"elbow", 7}}; }) == "hold");
  CHECK(key([](O& o) { o.hold_state = "shut"; }) == "hold_state");
  CHECK(key([](O& o) { o.position = Vector3d(0, 0, std::nan("")); }) == "base.position");
  CHECK(key([](O& o) { o.rpy = Eigen::Vector2d(0, 0); }) == "base.rpy");
  Written plain(with(kHinge));
  plain.options.group = "arm";
  CHECK(refused_key([&] { plain.robot(); }) == "group");
  const auto srdf = [](const std::string& inner) {
    return Written(with(kHinge), "<robot name='r'>\n" + inner + "</robot>").message();
  };
  CHECK_THAT(srdf("<group name='g'><joint name='x'/></group>"), Contains("robot.srdf:2: 'x' is not a joint of"));
  CHECK_THAT(srdf("<group name='g'><group name='g'/></group>"),
             Contains("robot.srdf:2: the group 'g' is part of itself"));
  CHECK_THAT(srdf("<group name='g'><chain base_link='b' tip_link='a'/></group>"),
             Contains("robot.srdf:2: the base_link 'b' of this chain is not on the way"));
  CHECK_THAT(srdf("<group name='g'><link name='x'/></group>"), Contains("robot.srdf:2: 'x' is not a link of"));
  CHECK_THAT(srdf("<group name='g'>\n<chain base_link='a' tip_link='x'/></group>"),
             Contains("robot.srdf:3: 'x' is not a link of"));
  CHECK_THAT(srdf("<group name='g'><group name='x'/></group>"),
             Contains("robot.srdf:2: the group 'x' is not in this file"));
  CHECK_THAT(srdf("<group_state name='s' group='g'><joint name='x' value='0'/></group_state>"),
             Contains("robot.srdf:2: 'x' is not a joint of"));
  CHECK_THAT(srdf("<group name='g'>"), Contains("robot.srdf:") && Contains("not XML"));
  CHECK_THAT(srdf("<disable_collisions link1='a'/>"), Contains("robot.srdf:2:") && Contains("'link2'"));
  CHECK_THAT(srdf("<group_state name='s' group='g'><joint name='j' value='inf'/></group_state>"),
             Contains("robot.srdf:2: 'value' of <joint> must be a finite number, not 'inf'"));
}

TEST_CASE("urdf: meshes are found and covered") {
  const std::string mesh =
      "<robot name='r'><link name='a'/><link name='b'>\n<collision><origin xyz='0 0 1'/><geometry>"
      "<mesh filename='package://arm/meshes/part.obj' scale='2 1 1'/></geometry></collision></link>\n" +
      kHinge + "</robot>";
  Written files(mesh);
  CHECK_THAT(files.message(), Contains("robot.urdf:2: the mesh 'package://arm/meshes/part.obj' was not found") &&
                                  Contains("set 'packages'"));
  std::filesystem::create_directories(files.path() / "somewhere/arm/meshes");
  std::ofstream(files.path() / "somewhere/arm/meshes/part.obj")
      << "v 0 0 0\nv 0.2 0 0\nv 0 0.1 0\nv 0 0 0.3\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
  const RobotPtr found = files.robot();  // by its name
  REQUIRE(found->capsules.size() == 1);
  const Capsule& capsule = found->capsules[0];
  const Vector3d way = capsule.to - capsule.from;
  for (const Vector3d& corner : {Vector3d(0, 0, 1), Vector3d(0.4, 0, 1), Vector3d(0, 0.1, 1), Vector3d(0, 0, 1.3)}) {
    const double t = std::clamp((corner - capsule.from).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
    CHECK((corner - capsule.from - t * way).norm() <= capsule.radius * (1 + 1e-14));
  }
  files.options.packages = "somewhere";
  CHECK(files.robot()->capsules[0].radius == capsule.radius);
  files.options.packages = "somewhere/arm";
  CHECK(files.robot()->capsules[0].radius == capsule.radius);
  files.options.packages = "";
  std::filesystem::create_directories(files.path() / "other");
  std::ofstream(files.path() / "other/part.obj") << "v 0 0 0\n";
  CHECK_THAT(files.message(), Contains("and 2 files below"));
}

TEST_CASE("urdf: the Panda and the UR5 of their makers stand as their joints say") {
  const auto panda = data_file("planning/mbm/panda.urdf"), spheres = data_file("planning/mbm/panda_spherized.urdf"),
             ur5 = data_file("planning/mbm/ur5_spherized.urdf");
  if (!panda || !spheres || !ur5) return;
  UrdfRobotOptions options;
  options.file = "panda_spherized.urdf";
  options.srdf = "panda.srdf";
  options.group = "panda_arm";
  const RobotPtr robot = make_urdf_robot(options, panda->parent_path());
  CHECK(robot->capsules.size() == 59);
  CHECK(robot->kinematics->dimension() == 7);
  CHECK(robot->states.count("ready") == 1);
  // Franka Emika's modified table of Denavit and Hartenberg.
  constexpr double kQuarter = 1.57079632679489662;
  const double table[7][3] = {{0, 0, 0.333},         {0, -kQuarter, 0},           {0, kQuarter, 0.316},
                              {0.0825, kQuarter, 0}, {-0.0825, -kQuarter, 0.384}, {0, kQuarter, 0},
                              {0.088, kQuarter, 0}};
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Frame> links;
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(7, [&] { return unit(engine); });
    robot->kinematics->place(q, links);
    Affine3d frame = Affine3d::Identity();
    for (int i = 0; i < 7; ++i) {
      frame = frame * AngleAxisd(table[i][1], Vector3d::UnitX()) * Translation3d(table[i][0], 0, 0) *
              AngleAxisd(q[i], Vector3d::UnitZ()) * Translation3d(0, 0, table[i][2]);
      CHECK((affine(links[static_cast<std::size_t>(i) + 1]).matrix() - frame.matrix()).norm() <
            1e-9);  // pi as 1.57079632679
    }
  }
  // Meshes: every corner in a capsule of its link.
  options.file = "panda.urdf";
  const RobotPtr meshes = make_urdf_robot(options, panda->parent_path());
  CHECK(meshes->capsules.size() == 11);
  const std::vector<Vector3d> corners = read_mesh(panda->parent_path() / "panda_meshes/link3.obj").positions;
  for (const Vector3d& corner : corners) {
    double outside = kInfinity;
    for (const Capsule& c : meshes->capsules) {
      if (meshes->kinematics->link_name(c.link) != "panda_link3") continue;
      const double t = std::clamp((corner - c.from).dot(c.to - c.from) / (c.to - c.from).squaredNorm(), 0.0, 1.0);
      outside = std::min(outside, (corner - c.from - t * (c.to - c.from)).norm() - c.radius);
    }
    CHECK(outside <= 1e-12);
  }
  options = {};
  options.file = "ur5_spherized.urdf";
  options.srdf = "ur5.srdf";
  const RobotPtr second = make_urdf_robot(options, ur5->parent_path());
  CHECK(second->kinematics->dimension() == 6);
  CHECK_FALSE(second->self.empty());
}

}  // namespace leastcost::test
