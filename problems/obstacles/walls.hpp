// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/drawing/draws_poses.hpp>

namespace leastcost {

/// One thing that a place may be too near to.
struct Wall {
  int obstacle = -1;           ///< what Walls::obstacle_name() is asked for
  double gap = 0;              ///< distance minus what is required, length units
  Eigen::VectorXd slope = {};  ///< derivative of the gap by the place, ambient coordinates; one of them at a kink
  /// Of the distance from the core, which is gap + required; infinity where no core is known.
  double required = std::numeric_limits<double>::infinity();
  double at = 0;  ///< on a move from a to b: the share of it after which the gap is least
};

/// In the plane: a disc of places that are taken. All of what is in the way is the hull of such discs, piece by piece
/// (a ball is one, a box with a clearance four), so that a shortest path bends nowhere but around them.
struct Round {
  int obstacle = -1;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
};

/// A plane between a straight move and a convex obstacle with its clearance: normal . x >= offset at all places of the
/// move, and nothing that is nearer to the obstacle than required lies beyond it.
struct SupportPlane {
  int obstacle = -1;
  Eigen::VectorXd normal = {};  ///< of length one, away from the obstacle
  double offset = 0;
  double gap = 0;              ///< of the move
  Eigen::VectorXd place = {};  ///< of the move, where it is nearest
};

/// What keeps a place out: obstacles in the space itself, or those that a robot in a configuration would touch. Places
/// are ambient columns of the domain (a quaternion of a pose is four of them). Immutable, and shared by threads.
class Walls {
 public:
  using Vector = Eigen::VectorXd;

  virtual ~Walls() = default;
  /// Rows of a place.
  virtual Eigen::Index dimension() const = 0;
  /// The largest of the lengths that gaps are computed from (coordinates, radii): what rounding is measured by.
  virtual double size() const { return 1; }
  /// The walls with a gap below `reach` at x, ascending by obstacle; some others may be among them.
  virtual void near(const Vector& x, double reach, std::vector<Wall>& found) const = 0;
  /// Over all places of the move from a to b that the domain makes; names the nearest obstacle.
  virtual MoveClearance clearance(const Vector& a, const Vector& b) const = 0;
  /// Whether that move is clear, contact included, as far as it can be told; may be quicker than the clearance.
  virtual bool clears(const Vector& a, const Vector& b) const { return clearance(a, b).upper >= 0; }
  /// The walls with a gap below `reach` somewhere on that move, the gap of each the least there, its slope that of the
  /// place. All that are known: the nearest will do; and a slope of no size where none is.
  virtual void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const;
  /// How far that move may be displaced, at least, before it meets the core of an obstacle, which it could be drawn
  /// through to the other side; no more than `reach` is asked for. `reach` itself: not known, hence not watched.
  virtual double room(const Vector& a, const Vector& b, double reach) const;
  /// All discs of the obstacles that come into a box of the plane, ascending by obstacle; nothing where walls are not
  /// made of discs.
  virtual std::optional<std::vector<Round>> rounds(const Eigen::AlignedBox2d& box) const;
  /// Whether places are points among obstacles that stand in the space itself, and no gap is less than the distance
  /// says.
  virtual bool gaps_are_distances() const { return false; }
  /// One plane for each wall with a gap below `reach` somewhere on a straight move that goes into none, ascending by
  /// obstacle. False where a wall there is not known to be convex.
  virtual bool planes(const Vector& a, const Vector& b, double reach, std::vector<SupportPlane>& found) const;
  virtual std::string obstacle_name(int obstacle) const = 0;
  /// The same walls for a solve, whose looks are mostly beside earlier ones: they may remember what they saw. They
  /// answer alike and may be shared by threads. Null: there is nothing to gain.
  virtual std::shared_ptr<const Walls> remembering() const { return nullptr; }
  virtual void draw(const DrawnPaths& paths, Drawing& out) const;
  /// Of a robot on its way; nothing where places are no configurations of one.
  virtual std::optional<PoseStrip> pose_strip(const Points&) const { return std::nullopt; }
};

inline void Walls::along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const {
  found.clear();
  const MoveClearance least = clearance(a, b);
  if (least.obstacle >= 0 && least.upper < reach) found.push_back({.obstacle = least.obstacle, .gap = least.upper});
}

inline double Walls::room(const Vector&, const Vector&, double reach) const { return reach; }

inline std::optional<std::vector<Round>> Walls::rounds(const Eigen::AlignedBox2d&) const { return std::nullopt; }

inline bool Walls::planes(const Vector&, const Vector&, double, std::vector<SupportPlane>&) const { return false; }

inline void Walls::draw(const DrawnPaths&, Drawing&) const {}

}  // namespace leastcost
