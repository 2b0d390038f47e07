// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/family/family.hpp>
#include <leastcost/framework/replan/waypoints.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/framework/trajectory/trajectory.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// What became of an end of the configuration.
struct PlacedEnd {
  Eigen::VectorXd given;  ///< the point that was asked for, coordinate
  PathEnd end;            ///< the end that it became
  double moved = 0;       ///< distance between the two, length units
};

/// A further way to a first path, for other locally least-cost paths.
struct FamilyWay {
  std::string name;                                ///< in words, for reports: "bow 90 degrees"
  std::shared_ptr<const Initializer> initializer;  ///< makes the first path
};

/// The objects that a configuration describes, ready for find_path(). All of it may be
/// replaced before solve().
struct RunParts {
  Problem problem;                                 ///< what is minimised, and between which ends
  std::shared_ptr<const Initializer> initializer;  ///< makes the first path
  std::vector<FamilyWay> family;         ///< besides the initializer; empty, and no windings: one path is sought
  int windings = 0;                      ///< of the family: images of the target up to so many turns on
  std::shared_ptr<const Solver> solver;  ///< moves the points to the minimum
  FindOptions options;                   ///< the post-processors among them
  WaypointOptions waypoints;             ///< points at given distances along the path, for those who follow it
  TrajectoryOptions trajectory;          ///< times along the path
  std::shared_ptr<const Robot> robot;    ///< whose configurations the points are; null: of none
  PlacedEnd source, target;              ///< where problem.source and problem.target came from; empty in a ring
  std::vector<PlacedEnd> goals;          ///< besides the target: the cheapest to reach is taken
  std::vector<std::string> notes;        ///< what the user should know about how it was composed

  /// Whether several paths are sought.
  bool wants_family() const { return !family.empty() || windings > 0 || !goals.empty(); }
};

}  // namespace leastcost
