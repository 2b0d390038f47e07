// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <leastcost/problems/robots/kinematics.hpp>

namespace leastcost {

/// A joint between two links. At the value q it turns its child by q (rad) about an axis, or moves it by q along one;
/// q = factor * (a coordinate of the configuration) + offset: joints of one coordinate mimic each other.
struct TreeJoint {
  int parent = 0;     ///< a link; joint i moves link i + 1, and parents come before their children
  Frame origin = {};  ///< of the child at q = 0, in the frame of the parent
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< in the frame of the child, through its origin; any length but 0
  bool slides = false;                              ///< along its axis; else it turns about it
  int coordinate = 0;                               ///< number of the coordinate that moves it
  double factor = 1, offset = 0;                    ///< it is moved by factor * coordinate + offset
};

/// Links joined to a tree, link 0 at its root.
struct JointTree {
  Frame base = {};                      ///< of link 0
  std::vector<TreeJoint> joints = {};   ///< parents before their children
  std::vector<std::string> links = {};  ///< for messages: a name for each, one more than joints
  Eigen::VectorXd lower = {};           ///< of the coordinates, possibly infinite
  Eigen::VectorXd upper = {};           ///< greatest coordinates; inf: none
};

/// A tree of joints that turn or slide. A coordinate is an angle in rad or a length.
class TreeKinematics final : public Kinematics {
 public:
  /// Throws OptionError("joints"), ("links"), ("lower"), ("upper"), ("base") for a tree that is none.
  explicit TreeKinematics(JointTree tree);
  const JointTree& tree() const { return tree_; }  ///< the joints that it was made of

  Eigen::Index dimension() const override { return tree_.lower.size(); }
  int space() const override { return 3; }
  int link_count() const override { return static_cast<int>(tree_.links.size()); }
  std::string link_name(int link) const override { return tree_.links[static_cast<std::size_t>(link)]; }
  void place(const Vector& configuration, std::vector<Frame>& links) const override;
  void jacobian(const Vector& configuration, const std::vector<Frame>& links, int link, const Eigen::Vector3d& point,
                Eigen::Matrix3Xd& derivative) const override;
  Vector reach(int link, const Eigen::Vector3d& local) const override { return reach_from(0, link, local); }
  Vector reach_from(int seen_from, int link, const Eigen::Vector3d& local) const override;
  bool carries(int link, int other) const override;
  double steepest(const Vector& reach, int seen_from) const override;
  MotionBound motion(const Vector& a, const Vector& b, const Vector& reach, int seen_from) const override;
  PointMotion moving(const Vector& x, const std::vector<Frame>& links, const Vector& way, int link,
                     const Eigen::Vector3d& point, int seen_from) const override;
  Vector lower() const override { return tree_.lower; }
  Vector upper() const override { return tree_.upper; }

 private:
  /// The child's rotation at q is fixed + cos(q) cosine + sin(q) sine, in the frame of the parent.
  struct Turn {
    Eigen::Matrix3d fixed, cosine, sine;
  };
  /// A joint in the order in which motion() meets them.
  struct Step {
    int joint = 0;
    bool last = false;    ///< of its coordinate
    bool single = false;  ///< the only one of its coordinate
  };
  /// The joints from a link to another: down to the last common one, then up.
  struct Way;

  const TreeJoint& joint(int number) const { return tree_.joints[static_cast<std::size_t>(number)]; }
  Way way(int seen_from, int link) const;

  JointTree tree_;
  std::vector<Turn> turns_;
  std::vector<std::vector<int>> paths_;   ///< of the links: the joints from the root
  std::vector<std::vector<Step>> steps_;  ///< as seen from each link: its own joints from it to the root, the others
};

}  // namespace leastcost
