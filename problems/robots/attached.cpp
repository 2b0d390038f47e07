// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/attached.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/robots/always_touching.hpp"

namespace leastcost {
namespace {

constexpr int kOfRobot = -1;

class Attacher {
 public:
  Attacher(const Robot& robot, const std::vector<AttachedObject>& objects) : out_(robot), objects_(objects) {
    for (std::size_t part = 0; part < robot.capsules.size(); ++part) owners_.push_back(robot.part_name(part));
    object_of_.assign(robot.capsules.size(), kOfRobot);
  }

  std::shared_ptr<const Robot> attach() {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      check_names(i);
      add(i);
    }
    sort_by_link();
    const std::size_t before = out_.self.size();
    add_pairs();
    say_what_is_added();
    leave_out_what_always_touches(out_, before);
    return make_robot(std::move(out_));
  }

 private:
  static std::string key(std::size_t object, const char* option) { return std::to_string(object) + "." + option; }

  void check_names(std::size_t i) const {
    std::vector<std::string> known = frame_names(out_);
    for (const AttachedObject& one : objects_) known.push_back(one.name);
    for (const std::string& name : objects_[i].touches) {
      if (std::count(known.begin(), known.end(), name) > 0) continue;
      std::string message = "the robot has no link '" + name + "'; it has: ";
      for (const std::string& one : known) message += (&one == known.data() ? "" : ", ") + one;
      throw OptionError(key(i, "touches"), message);
    }
  }

  void add(std::size_t i) {
    const AttachedObject& object = objects_[i];
    if (object.shape.capsules.empty()) throw OptionError(key(i, "shape"), "must have at least one part");
    NamedFrame frame;
    try {
      frame = find_frame(out_, object.link);
    } catch (const OptionError& error) {
      throw OptionError(key(i, "link"), error.reason());
    }
    for (Capsule capsule : object.shape.capsules) {
      capsule.link = frame.link;
      capsule.from = frame.place.at(object.pose.at(capsule.from));
      capsule.to = frame.place.at(object.pose.at(capsule.to));
      out_.capsules.push_back(capsule);
      owners_.push_back(object.name);
      object_of_.push_back(static_cast<int>(i));
    }
  }

  /// What is near is looked for link by link: capsules ascend by it. Pairs get the new numbers.
  void sort_by_link() {
    std::vector<int> order(out_.capsules.size()), place(order.size());
    std::iota(order.begin(), order.end(), 0);
    const auto link = [&](int k) { return out_.capsules[static_cast<std::size_t>(k)].link; };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return link(a) < link(b); });
    const Robot before = out_;
    const std::vector<int> objects = object_of_;
    out_.owners.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const auto from = static_cast<std::size_t>(order[k]);
      place[from] = static_cast<int>(k);
      out_.capsules[k] = before.capsules[from];
      out_.owners[k] = owners_[from];
      object_of_[k] = objects[from];
    }
    for (auto& [i, j] : out_.self) {
      i = place[static_cast<std::size_t>(i)];
      j = place[static_cast<std::size_t>(j)];
    }
  }

  bool may_touch(int object, std::size_t other) const {
    if (object == kOfRobot) return false;
    const std::vector<std::string>& names = objects_[static_cast<std::size_t>(object)].touches;
    return std::count(names.begin(), names.end(), out_.owners[other]) > 0;
  }

  void add_pairs() {
    for (std::size_t i = 0; i < out_.capsules.size(); ++i) {
      for (std::size_t j = i + 1; j < out_.capsules.size(); ++j) {
        if (object_of_[i] == kOfRobot && object_of_[j] == kOfRobot) continue;
        if (out_.capsules[i].link == out_.capsules[j].link) continue;
        if (may_touch(object_of_[i], j) || may_touch(object_of_[j], i)) continue;
        out_.self.emplace_back(static_cast<int>(i), static_cast<int>(j));
      }
    }
  }

  void say_what_is_added() {
    constexpr double kMillimetres = 1000;
    for (const AttachedObject& object : objects_) {
      out_.whose += out_.whose.empty() ? "the robot, and to " : ", and to ";
      if (object.shape.adds > 0)
        out_.whose += "capsules that cover '" + object.name + "' and exceed it by at most " +
                      std::to_string(static_cast<long>(std::ceil(kMillimetres * object.shape.adds))) + " mm";
      else
        out_.whose += "'" + object.name + "'";
    }
  }

  Robot out_;
  const std::vector<AttachedObject>& objects_;
  std::vector<std::string> owners_;  ///< of the capsules in the order in which they were added
  std::vector<int> object_of_;       ///< of the capsules: kOfRobot, or the number of the object
};

}  // namespace

std::shared_ptr<const Robot> with_attached(const Robot& robot, const std::vector<AttachedObject>& objects) {
  if (objects.empty()) return make_robot(robot);
  if (robot.kinematics->space() != 3) throw OptionError("0", "needs a robot in space, and this one is in the plane");
  return Attacher(robot, objects).attach();
}

}  // namespace leastcost
