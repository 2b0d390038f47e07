// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "urdf/joint_choice.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

/// "'a', 'b'"
template <class Names>
std::string listed(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text.empty() ? "none" : text;
}

class Chooser {
 public:
  Chooser(const UrdfRobotOptions& options, const UrdfModel& urdf, const SrdfModel* srdf)
      : options_(options), urdf_(urdf), srdf_(srdf) {}

  JointChoice choose() {
    choose_coordinates();
    hold_the_others();
    return out_;
  }

 private:
  const UrdfJoint& joint(int number) const { return urdf_.joints[static_cast<std::size_t>(number)]; }
  double lower(const UrdfJoint& joint) const { return options_.soft_limits ? joint.soft_lower : joint.lower; }
  double upper(const UrdfJoint& joint) const { return options_.soft_limits ? joint.soft_upper : joint.upper; }

  std::set<int> group() const {
    std::set<int> all;
    if (options_.group.empty()) {
      for (int i = 0; i < static_cast<int>(urdf_.joints.size()); ++i) all.insert(i);
      return all;
    }
    if (!srdf_) throw OptionError("group", "needs the SRDF that defines it: give 'srdf'");
    const auto found = srdf_->groups.find(options_.group);
    if (found != srdf_->groups.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, joints] : srdf_->groups) names.push_back(name);
    if (names.empty()) throw OptionError("group", "has no meaning here, because the SRDF defines no groups: remove it");
    throw OptionError("group", "the SRDF has no group '" + options_.group + "'; it has: " + listed(names));
  }

  /// A joint that is held and one whose limits leave it one value have none.
  void choose_coordinates() {
    out_.coordinates.assign(urdf_.joints.size(), -1);
    std::vector<double> least, most;
    for (const int i : group()) {
      const UrdfJoint& one = joint(i);
      if (one.kind == UrdfJoint::Kind::unsupported)
        throw OptionError(options_.group.empty() ? "file" : "group",
                          "the joint '" + one.name + "' is " + one.type +
                              "; joints that turn or slide can move: choose a group of the SRDF without it");
      if (!one.moves() || one.mimic || options_.hold.count(one.name) > 0 || !(lower(one) < upper(one))) continue;
      out_.coordinates[static_cast<std::size_t>(i)] = static_cast<int>(least.size());
      least.push_back(lower(one));
      most.push_back(upper(one));
      out_.names.push_back(one.name);
    }
    if (least.empty()) throw OptionError(options_.group.empty() ? "file" : "group", "no joint of it moves");
    const auto count = static_cast<Eigen::Index>(least.size());
    out_.lower = Eigen::Map<Eigen::VectorXd>(least.data(), count);
    out_.upper = Eigen::Map<Eigen::VectorXd>(most.data(), count);
  }

  void hold_the_others() {
    std::map<std::string, double> given;
    if (!options_.hold_state.empty()) {
      const SrdfState* state = nullptr;
      std::vector<std::string> names;
      if (srdf_) {
        for (const SrdfState& one : srdf_->states) {
          names.push_back(one.name);
          if (one.name == options_.hold_state) given.insert(one.joints.begin(), one.joints.end()), state = &one;
        }
      }
      if (state == nullptr)
        throw OptionError("hold_state",
                          "the SRDF has no state '" + options_.hold_state + "'; it has: " + listed(names));
    }
    for (const auto& [name, value] : options_.hold) {
      const int found = urdf_.find_joint(name);
      if (found < 0 || !joint(found).moves() || joint(found).mimic) {
        std::vector<std::string> names;
        for (const UrdfJoint& one : urdf_.joints)
          if (one.moves() && !one.mimic) names.push_back(one.name);
        throw OptionError("hold", "'" + name + "' is not a joint that moves by itself; these are: " + listed(names));
      }
      if (!(value >= joint(found).lower && value <= joint(found).upper))
        throw OptionError("hold", "the value of '" + name + "' is outside its limits, " +
                                      short_number(joint(found).lower, 9) + " to " +
                                      short_number(joint(found).upper, 9));
      given[name] = value;
    }
    out_.values.assign(urdf_.joints.size(), 0);
    for (std::size_t i = 0; i < urdf_.joints.size(); ++i) {
      const UrdfJoint& one = urdf_.joints[i];
      if (!one.moves() || one.mimic) continue;
      const auto value = given.find(one.name);
      out_.values[i] = value != given.end() ? value->second : std::clamp(0.0, one.lower, one.upper);
    }
    for (std::size_t i = 0; i < urdf_.joints.size(); ++i)
      if (const auto& mimic = urdf_.joints[i].mimic)
        out_.values[i] = mimic->factor * out_.values[static_cast<std::size_t>(mimic->joint)] + mimic->offset;
  }

  const UrdfRobotOptions& options_;
  const UrdfModel& urdf_;
  const SrdfModel* srdf_;
  JointChoice out_;
};

}  // namespace

JointChoice choose_joints(const UrdfRobotOptions& options, const UrdfModel& urdf, const SrdfModel* srdf) {
  return Chooser(options, urdf, srdf).choose();
}

}  // namespace leastcost
