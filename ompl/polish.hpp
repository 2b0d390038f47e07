// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <leastcost/framework/base/words.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/ompl/forward.hpp>
#include <leastcost/problems/obstacles/checker_walls.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// Complete as it is: {} minimises the length, with the planner's StateValidityChecker asked for yes or no. Places are
/// columns of StateColumns, and so are the dimensions of cost, domain and walls.
struct PolishOptions {
  std::shared_ptr<const SegmentCost> cost = {};           ///< else StateColumns::length()
  std::shared_ptr<const ConstraintManifold> domain = {};  ///< without obstacles; else StateColumns::domain()
  /// How far a turn by one radian counts as in the columns (StateColumns). Costs and walls that are given know it:
  /// RobotWalls of a PlanarBody or SpatialBody with this turn, through make_pose_walls().
  double turn = 1;
  /// What is known of the obstacles; at most one of the two. Without any, whether places are free is asked of the
  /// planner's checker as finely as the planner asks, and a clearance is sampled, not proved.
  std::shared_ptr<const Walls> walls = {};
  /// Its function is, unless given, clearance() of the planner's checker, a signed distance in the columns: say its
  /// Lipschitz constant. Then clearances are proved.
  std::optional<DistanceChecker> distance = {};
  /// Whether find_path() is asked at all. A chain among the many faces of meshes, with a body of many, may take
  /// minutes, or find no place for its points in a narrow passage; then the path is only shortened and pulled tight.
  bool search = true;
  /// Most plans of random trees that stand beside the given one, on whatever side of the obstacles: under a length of a
  /// constant metric, among walls that tell quickly whether a move is clear. 0: none. Where states have quaternions at
  /// most 8, whose best pieces are put together.
  int other_plans = 16;
  FindOptions find = {.points = 100};         ///< points are a number; without post-processors
  std::shared_ptr<const Solver> solver = {};  ///< else Newton
  std::shared_ptr<const Kernel> kernel = {};  ///< else Expm1Square
};

/// What became of a plan.
enum class PolishOutcome {
  polished,   ///< what find_path() came to
  tightened,  ///< that is not valid, or costs more: the given path, or another plan, with shortcuts, pulled tight
  given       ///< nothing valid costs less
};
Words<PolishOutcome> words(PolishOutcome);

/// A plan after polish().
struct Polished {
  PolishOutcome outcome = PolishOutcome::given;          ///< what became of it
  std::shared_ptr<ompl::geometric::PathGeometric> path;  ///< ends are those of the given path, to the last digit
  double cost = 0;                                       ///< of this path
  double given_cost = 0;                                 ///< of the given one
  std::optional<Clearance> clearance;                    ///< of this path; nothing where it was interrupted
  Result result;    ///< of find_path(): its certificate is that of this path where the outcome is `polished`
  std::string why;  ///< why this is not what find_path() came to; empty where it is
  /// Whether the polished path has a certificate.
  bool certified() const { return outcome == PolishOutcome::polished && result.status == Status::certified; }
};

/// A planner's path, improved: never dearer than it was given, and valid in the words of the planner (its checker at
/// every state, its motion validator at every move, the bounds of the space) and by the clearance of its moves. A path
/// that is better but not valid is not returned: `why` says so. Of a path that comes back as it was given the states
/// are valid; its moves are the planner's.
///
/// First the path is shortened, by shortcuts, beside other plans (PolishOptions::other_plans) the cheapest of which is
/// pulled tight; then find_path() begins there. The path may end up on another side of an obstacle, where that is
/// cheaper. Costs are compared on both paths in small pieces where a long move would not
/// have the cost of its parts.
///
/// Deadline and stop of the monitor hold for both; then the paths are looked at, which takes about as long as the
/// planner's check of the given path. Throws InputError for a space that is not set up, a path with less than two
/// states, with a state that is not valid, or whose moves are not straight in the columns (Dubins curves), for parts
/// that do not fit, and for a cost that is infinite on the given path.
Polished polish(const ompl::geometric::PathGeometric& path, const PolishOptions& options = {},
                const Monitor& monitor = {});

}  // namespace leastcost
