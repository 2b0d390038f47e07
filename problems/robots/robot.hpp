// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/robots/kinematics.hpp>

namespace leastcost {

/// All points within a radius of a segment that is fixed to a link; a ball where its ends are one point.
struct Capsule {
  int link = 0;                                                                  ///< that it is fixed to
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< coordinates of the link
  double radius = 0;                                                             ///< length units
};

/// All points within a radius of a triangle that is fixed to a link, in a workspace of three dimensions.
struct Plate {
  int link = 0;                                 ///< that it is fixed to
  std::array<Eigen::Vector3d, 3> corners = {};  ///< coordinates of the link
  double radius = 0;                            ///< length units
};

/// A frame with a name, fixed to a link of the kinematics: of a URDF each link has one, those that stand still against
/// each other on one link of the kinematics.
struct NamedFrame {
  int link = 0;      ///< of the kinematics
  Frame place = {};  ///< in the frame of the link
};

/// A robot: what moves, its shape, and which of its parts must not touch each other.
struct Robot {
  std::shared_ptr<const Kinematics> kinematics;  ///< where links are
  std::vector<Capsule> capsules = {};            ///< parts of the robot
  std::vector<std::pair<int, int>> self = {};    ///< numbers of capsules on different links
  std::vector<Plate> plates = {};                ///< further parts
  std::string whose = {};                        ///< what the parts stand for, for people: a clearance is one of theirs
  std::map<std::string, Eigen::VectorXd> states = {};  ///< configurations that have a name: "home"
  std::map<std::string, NamedFrame> frames = {};       ///< empty: the links of the kinematics
  std::vector<std::string> owners = {};  ///< of the capsules, for people: "panda_hand"; empty: their links
  std::vector<std::string> joints = {};  ///< names of the coordinates; empty: they have none
  Eigen::VectorXd velocity = {};         ///< largest of each coordinate, per s; infinite: not known; empty: of none is
  std::string unit = {};                 ///< of lengths, for people; empty: not known

  /// Parts are numbered: the capsules, then the plates.
  std::size_t parts() const { return capsules.size() + plates.size(); }
  /// Link of a part: capsules first, then plates.
  int link(std::size_t part) const {
    return part < capsules.size() ? capsules[part].link : plates[part - capsules.size()].link;
  }
  /// Radius of a part.
  double radius(std::size_t part) const {
    return part < capsules.size() ? capsules[part].radius : plates[part - capsules.size()].radius;
  }
  /// For messages.
  std::string part_name(std::size_t part) const {
    return part < owners.size() ? owners[part] : kinematics->link_name(link(part));
  }
};

/// Names of frames, or of the links of the kinematics where there are none.
std::vector<std::string> frame_names(const Robot& robot);
/// The frame of this name; without a name that of the last link. Throws OptionError("link") with the names there are.
NamedFrame find_frame(const Robot& robot, const std::string& name);

/// Throws OptionError("shape") for parts without a radius, of a link that is not there or that are no numbers, for
/// plates in the plane and where there is no part, OptionError("self") for pairs that are none, and
/// OptionError("owners"), ("joints"), ("velocity") for lists of another length.
std::shared_ptr<const Robot> make_robot(Robot robot);

}  // namespace leastcost
