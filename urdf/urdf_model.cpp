// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "urdf/urdf_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "urdf/xml_file.hpp"

namespace leastcost {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

Vector3d vector_of(const XmlElement& element, const char* name, const Vector3d& otherwise) {
  const auto numbers = element.numbers(name, 3);
  return numbers ? Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]) : otherwise;
}

/// rpy: about the fixed x, then y, then z.
Affine3d origin_of(const XmlElement& owner) {
  Affine3d out = Affine3d::Identity();
  const auto origin = owner.child("origin");
  if (!origin) return out;
  out.translation() = vector_of(*origin, "xyz", Vector3d::Zero());
  const Vector3d rpy = vector_of(*origin, "rpy", Vector3d::Zero());
  out.linear() = (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                  Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
                     .toRotationMatrix();
  return out;
}

double length_of(const XmlElement& shape, const char* name) {
  const double value = shape.required_number(name);
  if (!(value > 0)) shape.fail("'" + std::string(name) + "' of <" + shape.name() + "> must be greater than 0");
  return value;
}

UrdfCollision collision_of(const XmlElement& element, const std::string& file) {
  UrdfCollision out;
  out.origin = origin_of(element);
  out.place = file + ":" + std::to_string(element.line());
  const auto geometry = element.child("geometry");
  const std::vector<XmlElement> shapes = geometry ? geometry->children() : std::vector<XmlElement>{};
  if (shapes.size() != 1) element.fail("<collision> must have a <geometry> with one shape");
  const XmlElement& shape = shapes.front();
  const std::string type = shape.name();
  if (type == "sphere") {
    out.shape = urdf_shape::Sphere{length_of(shape, "radius")};
  } else if (type == "cylinder" || type == "capsule") {
    out.shape = urdf_shape::Cylinder{length_of(shape, "radius"), length_of(shape, "length"), type == "capsule"};
  } else if (type == "box") {
    shape.text("size");
    const Vector3d size = vector_of(shape, "size", Vector3d::Zero());
    if (!(size.minCoeff() > 0)) shape.fail("'size' of <box> must be three numbers greater than 0");
    out.shape = urdf_shape::Box{size};
  } else if (type == "mesh") {
    urdf_shape::Mesh mesh{shape.text("filename"), vector_of(shape, "scale", Vector3d::Ones())};
    if (!(mesh.scale.cwiseAbs().minCoeff() > 0)) shape.fail("'scale' of <mesh> must have no 0");
    out.shape = std::move(mesh);
  } else {
    shape.fail("<" + type + "> is not a known shape: give sphere, cylinder, capsule, box or mesh");
  }
  return out;
}

/// A joint and what its element said about others, which may come later in the file.
struct ReadJoint {
  UrdfJoint joint;
  XmlElement element;
  std::string mimics = {};
};

/// One that mimics another needs none: where nothing is known, files leave them out or have 0 for both.
void read_limits(const XmlElement& element, UrdfJoint& joint) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto limit = element.child("limit");
  if (const auto velocity = limit ? limit->number("velocity") : std::nullopt; velocity && *velocity > 0)
    joint.velocity = *velocity;  // many files have 0 where nothing is known
  const bool known = limit && (limit->number("lower").value_or(0) != 0 || limit->number("upper").value_or(0) != 0);
  if (joint.type == "continuous" || (joint.mimic && !known)) {
    joint.lower = joint.soft_lower = -kNone;
    joint.upper = joint.soft_upper = kNone;
    return;
  }
  if (!limit || (!limit->attribute("lower") && !limit->attribute("upper")))
    element.fail("the " + joint.type + " joint '" + joint.name +
                 "' has no limits: give <limit lower=\"..\" upper=\"..\"/>" +
                 (joint.kind == UrdfJoint::Kind::turns ? ", or make it continuous" : ""));
  joint.lower = joint.soft_lower = limit->number("lower").value_or(0);
  joint.upper = joint.soft_upper = limit->number("upper").value_or(0);
  if (joint.lower > joint.upper) limit->fail("'lower' of the joint '" + joint.name + "' is above its 'upper'");
  const auto safety = element.child("safety_controller");
  if (!safety) return;
  const double lower = std::max(joint.lower, safety->number("soft_lower_limit").value_or(joint.lower)),
               upper = std::min(joint.upper, safety->number("soft_upper_limit").value_or(joint.upper));
  if (lower >= upper) return;  // both left at 0, as many files have them, leave nothing
  joint.soft_lower = lower;
  joint.soft_upper = upper;
}

ReadJoint joint_of(const XmlElement& element, const UrdfModel& model) {
  ReadJoint read{{}, element};
  UrdfJoint& joint = read.joint;
  joint.name = element.text("name");
  joint.type = element.text("type");
  const auto link_of = [&](const char* role) {
    const auto part = element.child(role);
    if (!part) element.fail("the joint '" + joint.name + "' has no <" + role + ">");
    const std::string name = part->text("link");
    const int link = model.find_link(name);
    if (link < 0)
      part->fail("the " + std::string(role) + " '" + name + "' of the joint '" + joint.name +
                 "' is not a link of this file");
    return link;
  };
  joint.parent = link_of("parent");
  joint.child = link_of("child");
  joint.origin = origin_of(element);
  if (joint.type == "revolute" || joint.type == "continuous") {
    joint.kind = UrdfJoint::Kind::turns;
  } else if (joint.type == "prismatic") {
    joint.kind = UrdfJoint::Kind::slides;
  } else if (joint.type == "floating" || joint.type == "planar") {
    joint.kind = UrdfJoint::Kind::unsupported;
  } else if (joint.type != "fixed") {
    element.fail("'" + joint.type + "' is not a known type of joint: give revolute, continuous, prismatic or fixed");
  }
  if (!joint.moves()) return read;
  if (const auto axis = element.child("axis")) {
    joint.axis = vector_of(*axis, "xyz", Vector3d::UnitX());
    if (!(joint.axis.norm() > 0)) axis->fail("the axis of the joint '" + joint.name + "' is zero");
    joint.axis.normalize();
  }
  if (const auto mimic = element.child("mimic")) {
    read.mimics = mimic->text("joint");
    joint.mimic = UrdfMimic{-1, mimic->number("multiplier").value_or(1), mimic->number("offset").value_or(0)};
  }
  read_limits(element, joint);
  return read;
}

/// A joint that mimics one that mimics a third follows the third.
void resolve_mimics(std::vector<ReadJoint>& joints) {
  const auto find = [&](const std::string& name) {
    return std::find_if(joints.begin(), joints.end(), [&](const ReadJoint& j) { return j.joint.name == name; });
  };
  for (ReadJoint& read : joints) {
    if (!read.joint.mimic) continue;
    UrdfMimic all{-1, 1, 0};
    auto at = find(read.joint.name);
    for (std::size_t steps = 0; !at->mimics.empty(); ++steps) {
      all.offset += all.factor * at->joint.mimic->offset;
      all.factor *= at->joint.mimic->factor;
      const auto next = find(at->mimics);
      if (steps > joints.size())
        read.element.fail("the joint '" + read.joint.name + "' mimics '" + read.mimics +
                          "', and so on in a loop: one of them must move by itself");
      if (next == joints.end() || !next->joint.moves())
        read.element.fail("the joint '" + read.joint.name + "' mimics '" + at->mimics +
                          "', which is not a joint that moves by itself");
      at = next;
    }
    all.joint = static_cast<int>(at - joints.begin());
    read.joint.mimic->joint = all.joint;
    read.joint.mimic->offset = all.offset;
    read.joint.mimic->factor = all.factor;
  }
}

/// A joint that others mimic goes no farther than they can follow it.
void keep_mimics_within_limits(std::vector<ReadJoint>& joints, UrdfModel& model) {
  for (const ReadJoint& read : joints) {
    const UrdfJoint& follower = read.joint;
    if (!follower.mimic) continue;
    const auto [number, factor, offset] = *follower.mimic;
    UrdfJoint& leader = joints[static_cast<std::size_t>(number)].joint;
    if (factor == 0) {
      if (offset < follower.lower || offset > follower.upper)
        read.element.fail("the joint '" + follower.name +
                          "' always stands at its offset, as its multiplier is 0, and " + short_number(offset, 9) +
                          " is outside its limits");
      continue;
    }
    const double lower = leader.lower, upper = leader.upper;
    const auto cut = [factor = factor, offset = offset](double least, double most, double& low, double& high) {
      const double a = (least - offset) / factor, b = (most - offset) / factor;
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    };
    cut(follower.lower, follower.upper, leader.lower, leader.upper);
    cut(follower.lower, follower.upper, leader.soft_lower, leader.soft_upper);
    cut(follower.soft_lower, follower.soft_upper, leader.soft_lower, leader.soft_upper);
    if (leader.lower > leader.upper)
      read.element.fail("the joint '" + follower.name + "' mimics '" + leader.name + "': the limits of '" +
                        leader.name + "' leave no value at which '" + follower.name + "' is within its own");
    if (leader.soft_lower > leader.soft_upper) {  // soft limits that cannot be kept together say nothing
      leader.soft_lower = leader.lower;
      leader.soft_upper = leader.upper;
    }
    if (leader.lower == lower && leader.upper == upper) continue;
    model.notes.push_back(model.file + ":" + std::to_string(read.element.line()) + ": joint '" + leader.name +
                          "' is limited to " + short_number(leader.lower, 9) + " to " + short_number(leader.upper, 9) +
                          " (its own limits are " + short_number(lower, 9) + " to " + short_number(upper, 9) +
                          "), because '" + follower.name + "' mimics it");
  }
}

/// Sets the root and the parents' joints, and brings the joints into the order of the tree.
void make_tree(std::vector<ReadJoint> joints, const XmlElement& robot, UrdfModel& model) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    UrdfLink& child = model.links[static_cast<std::size_t>(joints[i].joint.child)];
    if (child.parent_joint >= 0)
      joints[i].element.fail("the link '" + child.name + "' is the child of '" +
                             joints[static_cast<std::size_t>(child.parent_joint)].joint.name + "' and of '" +
                             joints[i].joint.name + "'; it can have one parent");
    child.parent_joint = static_cast<int>(i);
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    if (model.links[i].parent_joint < 0) roots.push_back(static_cast<int>(i));
  const auto name_of = [&](int link) { return "'" + model.links[static_cast<std::size_t>(link)].name + "'"; };
  if (roots.empty()) robot.fail("every link is the child of a joint: the joints are in a cycle");
  if (roots.size() > 1)
    robot.fail("the links " + name_of(roots[0]) + " and " + name_of(roots[1]) +
               " are both the child of no joint; a robot has one root: join them");
  model.root = roots.front();

  std::vector<int> order, open = {model.root};
  while (!open.empty()) {
    const int link = open.back();
    open.pop_back();
    if (const int joint = model.links[static_cast<std::size_t>(link)].parent_joint; joint >= 0) order.push_back(joint);
    for (std::size_t i = joints.size(); i-- > 0;)
      if (joints[i].joint.parent == link) open.push_back(joints[i].joint.child);
  }
  if (order.size() != joints.size()) {
    std::set<int> reached(order.begin(), order.end());
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (reached.count(static_cast<int>(i)) == 0)
        joints[i].element.fail("the joint '" + joints[i].joint.name + "' is in a cycle of joints");
  }
  std::vector<int> place(joints.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  for (const int i : order) {
    UrdfJoint& joint = model.joints.emplace_back(std::move(joints[static_cast<std::size_t>(i)].joint));
    if (joint.mimic) joint.mimic->joint = place[static_cast<std::size_t>(joint.mimic->joint)];
  }
  for (UrdfLink& link : model.links)
    if (link.parent_joint >= 0) link.parent_joint = place[static_cast<std::size_t>(link.parent_joint)];
}

template <class Items>
int position_of(const Items& items, const std::string& name) {
  const auto at = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return at == items.end() ? -1 : static_cast<int>(at - items.begin());
}

}  // namespace

int UrdfModel::find_link(const std::string& name) const { return position_of(links, name); }

int UrdfModel::find_joint(const std::string& name) const { return position_of(joints, name); }

std::vector<int> UrdfModel::joints_above(int link) const {
  std::vector<int> above;
  for (int joint = links[static_cast<std::size_t>(link)].parent_joint; joint >= 0;
       joint = links[static_cast<std::size_t>(joints[static_cast<std::size_t>(joint)].parent)].parent_joint)
    above.push_back(joint);
  return above;
}

UrdfModel read_urdf(const std::filesystem::path& file) {
  const XmlFile xml(file, "robot");
  const XmlElement robot = xml.root();
  UrdfModel model;
  model.file = file.string();
  for (const XmlElement& element : robot.children())
    if (element.name().rfind("xacro:", 0) == 0)
      element.fail("this is a xacro file: expand it, as with `xacro FILE > robot.urdf`");
  constexpr std::size_t kMostLinks = 10000;
  std::set<std::string> names;
  for (const XmlElement& element : robot.children("link")) {
    if (names.size() == kMostLinks) element.fail("more than 10000 links");
    UrdfLink link{element.text("name")};
    if (!names.insert(link.name).second) element.fail("a second link '" + link.name + "': give each another name");
    for (const XmlElement& collision : element.children("collision"))
      link.collisions.push_back(collision_of(collision, model.file));
    model.links.push_back(std::move(link));
  }
  if (model.links.empty()) robot.fail("<robot> must have a <link>");
  std::vector<ReadJoint> joints;
  names.clear();
  for (const XmlElement& element : robot.children("joint")) {
    if (names.size() == kMostLinks) element.fail("more joints than links");
    joints.push_back(joint_of(element, model));
    const std::string& name = joints.back().joint.name;
    if (!names.insert(name).second) element.fail("a second joint '" + name + "': give each another name");
  }
  resolve_mimics(joints);
  keep_mimics_within_limits(joints, model);
  make_tree(std::move(joints), robot, model);
  return model;
}

}  // namespace leastcost
