// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/problems/methods/decides_moves.hpp>

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

/// What keeps a place out: obstacles in the space itself, or those that a robot in a configuration would touch. Places
/// are ambient columns of the domain (a quaternion of a pose is four of them). Immutable, and shared by threads. What
/// only some walls know is an ability, below; walls may also have DrawsItself and DrawsPoses.
class Walls : public HasAbilities<Walls> {
 public:
  using Vector = Eigen::VectorXd;

  /// Rows of a place.
  virtual Eigen::Index dimension() const = 0;
  /// The lengths that matter, which tolerances are measured by: of what moves, where that is known (a robot), and of
  /// what is in the way elsewhere.
  virtual double size() const { return 1; }
  /// The largest of the lengths that gaps are computed from (coordinates, radii): what rounding is measured by.
  virtual double computed_from() const { return size(); }
  /// The walls with a gap below `reach` at x, ascending by obstacle; some others may be among them.
  virtual void near(const Vector& x, double reach, std::vector<Wall>& found) const = 0;
  /// Over all places of the move from a to b that the domain makes; names the nearest obstacle.
  virtual MoveClearance clearance(const Vector& a, const Vector& b) const = 0;
  /// The walls with a gap below `reach` somewhere on that move, the gap of each the least there, its slope that of the
  /// place. All that are known: the nearest will do; and a slope of no size where none is.
  virtual void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const;
  /// How far that move may be displaced, at least, before it meets the core of an obstacle, which it could be drawn
  /// through to the other side; no more than `reach` is asked for. `reach` itself: not known, hence not watched.
  virtual double room(const Vector& a, const Vector& b, double reach) const;
  virtual std::string obstacle_name(int obstacle) const = 0;                                 ///< in messages
  virtual std::string depth_text(int /*obstacle*/, double /*missing*/) const { return ""; }  ///< as of ChecksMoves
};

inline void Walls::along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const {
  found.clear();
  const MoveClearance least = clearance(a, b);
  if (least.obstacle >= 0 && least.upper < reach) found.push_back({.obstacle = least.obstacle, .gap = least.upper});
}

inline double Walls::room(const Vector&, const Vector&, double reach) const { return reach; }

/// In the plane: a disc of places that are taken. All of what is in the way is the hull of such discs, piece by piece
/// (a ball is one, a box with a clearance four), so that a shortest path bends nowhere but around them.
struct Round {
  int obstacle = -1;                                 ///< its number; -1: none
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< place of its centre
  double radius = 0;                                 ///< with the clearance, length units
};

/// Ability of walls in the plane that are made of discs.
class HasRounds {
 public:
  virtual ~HasRounds() = default;
  bool present() const { return has_rounds(); }
  /// All that come into a box, ascending by obstacle.
  virtual std::vector<Round> rounds(const Eigen::AlignedBox2d& box) const = 0;

 private:
  virtual bool has_rounds() const = 0;
};

/// A plane between a straight move and a convex obstacle with its clearance: normal . x >= offset at all places of the
/// move, and nothing that is nearer to the obstacle than required lies beyond it.
struct SupportPlane {
  int obstacle = -1;            ///< its number; -1: none
  Eigen::VectorXd normal = {};  ///< of length one, away from the obstacle
  double offset = 0;            ///< of the plane from the origin, along the normal
  double gap = 0;               ///< of the move
  Eigen::VectorXd place = {};   ///< of the move, where it is nearest
};

/// Ability of walls that know which of them are convex.
class HasSupportPlanes {
 public:
  virtual ~HasSupportPlanes() = default;
  /// One plane for each wall with a gap below `reach` somewhere on a straight move that goes into none, ascending by
  /// obstacle. False where a wall there is not known to be convex.
  virtual bool planes(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double reach,
                      std::vector<SupportPlane>& found) const = 0;
};

/// Ability of walls whose gaps are distances, or less: a place with the gap -d is at least d from all that are free.
class GapsAreDistances {
 public:
  virtual ~GapsAreDistances() = default;
  bool present() const { return gaps_are_distances(); }

 private:
  virtual bool gaps_are_distances() const { return true; }
};

/// Ability of walls that are made of cores with a distance to be kept from each: a robot's parts among obstacles.
class HasThinnestCore {
 public:
  virtual ~HasThinnestCore() = default;
  /// The least distance that is required from any core, in length units of the places; infinity where there is none.
  virtual double thinnest() const = 0;
};

/// Ability of walls that are numbered from 0: the same number of them, some of which have moved, are the same walls.
class NumbersWalls {
 public:
  virtual ~NumbersWalls() = default;
  /// Number of walls.
  virtual int wall_count() const = 0;
};

/// Ability of walls for a solve, whose looks are mostly beside earlier ones: they may remember what they saw.
class Remembers {
 public:
  virtual ~Remembers() = default;
  /// The same walls, which answer alike and may be shared by threads. Null: there is nothing to gain.
  virtual std::shared_ptr<const Walls> remembering() const = 0;
};

/// Whether the move from a to b is clear of the walls.
inline bool clears(const Walls& walls, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const auto* decides = find_ability<DecidesMoves>(walls);
  return decides != nullptr ? decides->clears(a, b) : walls.clearance(a, b).upper >= 0;
}

/// Nothing where walls do not remember.
inline std::shared_ptr<const Walls> remembering(const Walls& walls) {
  const auto* remembers = find_ability<Remembers>(walls);
  return remembers != nullptr ? remembers->remembering() : nullptr;
}

}  // namespace leastcost
