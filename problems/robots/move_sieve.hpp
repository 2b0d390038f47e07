// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/robots/robot.hpp>
#include "problems/robots/segment_distance.hpp"

namespace leastcost {

class BroadPhase;

/// Looks at moves of a robot of capsules among obstacles for where they could touch: at the middle of the move, then of
/// its halves, and so on, so that what is in the way is mostly met at once. What is farther from everything than it can
/// go on its piece of the move is done with; only what is not is looked at again on the halves. Links are looked at
/// before their capsules, and obstacles as boxes that may be turned, which most of them are. Immutable, and shared by
/// threads.
class MoveSieve {
 public:
  using Vector = Eigen::VectorXd;
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

  /// `required`: of the distances of axes from the cores of the obstacles, without the radii of capsules. The robot has
  /// no plates.
  MoveSieve(std::shared_ptr<const Robot> robot, Obstacles obstacles, const std::vector<double>& required);

  /// Pieces of a move, 0 to 1.
  using Pieces = std::vector<std::pair<double, double>>;

  /// False: some place of the straight move touches by more than `rounding`, or it is too long for an answer in time,
  /// as one of millions of turns beside an obstacle is. True: what is not in one of the pieces `left`, ascending, is
  /// clear; within those no point of the robot goes farther than about `finest`.
  bool passes(const Vector& a, const Vector& b, double rounding, double finest, Pieces& left) const;

 private:
  struct Part {
    Capsule capsule;
    double half = 0;  ///< length of its axis
  };
  struct Link {
    int number = 0;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of a ball around its capsules; coordinates of the link
    double radius = 0;
    int first = 0, last = 0;  ///< parts
    Vector reach = {};
    bool moves = false;
  };
  struct Thing {
    OrientedBox box;
    double reach = 0;  ///< of its corners from its center
    double required = 0;
    bool exact = false;  ///< the box is the core, else it holds the core
  };
  struct Pair {
    int far = 0, near = 0;  ///< parts
    double required = 0;
  };
  struct LinkPair {
    int far = 0, near = 0;    ///< numbers in links_
    int first = 0, last = 0;  ///< pairs_
    Vector reach = {};        ///< of the parts of the farther link, as seen from the nearer one
    double required = 0;      ///< of the balls around the links, at most
  };
  /// What is not done with yet on a piece: a link and a thing, or a pair of links (thing < 0), and which of their
  /// parts.
  struct Open {
    int link = 0, thing = 0;
    std::uint64_t which = 0;
  };
  struct OnMove;
  enum class Found { clear, touches, open };

  void add_links(const std::vector<int>& order);
  void add_link_pairs(const std::vector<int>& order);
  Vector reach_from(int seen_from, int link) const;
  void things_near(const OnMove& move, std::size_t link, double rounding, std::vector<int>& found) const;
  Found look_at_thing(OnMove& move, Open& open, double half, double rounding) const;
  Found look_at_pair(OnMove& move, Open& open, double half, double rounding) const;
  double distance(const Segment3& axis, std::size_t thing) const;

  std::shared_ptr<const Robot> robot_;
  Obstacles obstacles_;
  std::vector<Part> parts_;  ///< by links
  std::vector<Link> links_;  ///< with parts, at most 64 each; a link with more is there several times
  std::vector<Thing> things_;
  std::vector<Pair> pairs_;
  std::vector<LinkPair> link_pairs_;
  double most_required_ = 0;
  std::shared_ptr<const BroadPhase> tree_;  ///< of the cores, where there are many
};

}  // namespace leastcost
