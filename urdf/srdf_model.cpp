// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "urdf/srdf_model.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

#include <leastcost/framework/base/errors.hpp>
#include "urdf/xml_file.hpp"

namespace leastcost {
namespace {

std::pair<std::string, std::string> in_order(std::string a, std::string b) {
  if (b < a) std::swap(a, b);
  return {std::move(a), std::move(b)};
}

/// The groups of a file; each is made when it is first asked for, as one may be part of another that comes before it.
class Groups {
 public:
  Groups(const XmlElement& root, const UrdfModel& robot) : robot_(robot) {
    for (const XmlElement& joint : root.children("virtual_joint")) virtual_.insert(joint.text("name"));
    for (const XmlElement& group : root.children("group")) {
      if (!elements_.emplace(group.text("name"), group).second)
        group.fail("a second group '" + group.text("name") + "': give each another name");
    }
  }

  std::map<std::string, std::set<int>> all() {
    for (const auto& [name, element] : elements_) made(name);
    return made_;
  }

 private:
  const std::set<int>& made(const std::string& name) {
    if (const auto done = made_.find(name); done != made_.end()) return done->second;
    const XmlElement& group = elements_.at(name);
    if (!open_.insert(name).second) group.fail("the group '" + name + "' is part of itself");
    std::set<int> joints;
    for (const XmlElement& part : group.children("joint")) joints.insert(joint(part, part.text("name")));
    for (const XmlElement& part : group.children("link")) {
      const int above = robot_.links[static_cast<std::size_t>(link(part, part.text("name")))].parent_joint;
      if (above >= 0) joints.insert(above);
    }
    for (const XmlElement& part : group.children("chain")) {
      const int base = link(part, part.text("base_link")), tip = link(part, part.text("tip_link"));
      std::vector<int> up = robot_.joints_above(tip), stop = robot_.joints_above(base);
      if (up.size() < stop.size() || !std::equal(stop.rbegin(), stop.rend(), up.rbegin()))
        part.fail("the base_link '" + part.text("base_link") + "' of this chain is not on the way from the root to '" +
                  part.text("tip_link") + "'");
      joints.insert(up.begin(), up.end() - static_cast<std::ptrdiff_t>(stop.size()));
    }
    for (const XmlElement& part : group.children("group")) {
      const std::string other = part.text("name");
      if (elements_.count(other) == 0) part.fail("the group '" + other + "' is not in this file");
      const std::set<int>& more = made(other);
      joints.insert(more.begin(), more.end());
    }
    return made_.emplace(name, std::move(joints)).first->second;
  }

  int link(const XmlElement& at, const std::string& name) const {
    const int found = robot_.find_link(name);
    if (found < 0) at.fail("'" + name + "' is not a link of " + robot_.file);
    return found;
  }
  int joint(const XmlElement& at, const std::string& name) const {
    const int found = robot_.find_joint(name);
    // Virtual joints, which fasten the root to the world, are in no URDF.
    if (found < 0 && virtual_.count(name) == 0) at.fail("'" + name + "' is not a joint of " + robot_.file);
    return found;
  }

  const UrdfModel& robot_;
  std::map<std::string, XmlElement> elements_;
  std::map<std::string, std::set<int>> made_;
  std::set<std::string> open_, virtual_;
};

/// What the file says about links that the robot does not have: passed over.
class UnknownLinks {
 public:
  UnknownLinks(const std::filesystem::path& file, const UrdfModel& robot) : file_(file.string()), robot_(robot) {}

  /// Whether the robot has all of them.
  bool known(const XmlElement& element, std::initializer_list<const char*> attributes) {
    bool all = true;
    for (const char* attribute : attributes) {
      const std::string name = element.text(attribute);
      if (robot_.find_link(name) >= 0) continue;
      all = false;
      if (names_.empty()) first_ = file_ + ":" + std::to_string(element.line()) + ": <" + element.name() + ">";
      names_.insert(name);
    }
    count_ += all ? 0 : 1;
    return all;
  }

  std::vector<std::string> notes() const {
    if (names_.empty()) return {};
    constexpr std::size_t kMost = 8;  // names of a tool with many links
    std::string list;
    std::size_t listed = 0;
    for (const std::string& name : names_)
      if (listed++ < kMost) list += (list.empty() ? "'" : ", '") + name + "'";
    if (names_.size() > kMost) list += " and " + std::to_string(names_.size() - kMost) + " others";
    const std::string ignored = count_ == 1 ? "it is ignored" : std::to_string(count_) + " such elements are ignored";
    return {first_ + " names links that " + robot_.file + " does not have (" + list + "); " + ignored};
  }

 private:
  std::string file_;
  const UrdfModel& robot_;
  std::set<std::string> names_;
  std::string first_;
  int count_ = 0;  ///< of elements
};

}  // namespace

bool SrdfModel::checks(const std::string& link, const std::string& other) const {
  const auto pair = in_order(link, other);
  if (disabled.count(pair) > 0) return false;
  return enabled.count(pair) > 0 || (off.count(link) == 0 && off.count(other) == 0);
}

SrdfModel read_srdf(const std::filesystem::path& file, const UrdfModel& robot) {
  const XmlFile xml(file, "robot");
  const XmlElement root = xml.root();
  SrdfModel model;
  model.groups = Groups(root, robot).all();
  for (auto& [name, joints] : model.groups) joints.erase(-1);
  for (const XmlElement& element : root.children("group_state")) {
    SrdfState state{element.text("name"), element.text("group"), {}};
    for (const XmlElement& joint : element.children("joint")) {
      const std::string name = joint.text("name");
      const int found = robot.find_joint(name);
      if (found < 0) joint.fail("'" + name + "' is not a joint of " + robot.file);
      if (robot.joints[static_cast<std::size_t>(found)].moves()) state.joints[name] = joint.required_number("value");
    }
    model.states.push_back(std::move(state));
  }
  UnknownLinks links(file, robot);
  for (const auto& [name, pairs] :
       {std::pair{"disable_collisions", &model.disabled}, {"enable_collisions", &model.enabled}})
    for (const XmlElement& pair : root.children(name))
      if (links.known(pair, {"link1", "link2"})) pairs->insert(in_order(pair.text("link1"), pair.text("link2")));
  for (const XmlElement& link : root.children("disable_default_collisions"))
    if (links.known(link, {"link"})) model.off.insert(link.text("link"));
  model.notes = links.notes();
  return model;
}

}  // namespace leastcost
