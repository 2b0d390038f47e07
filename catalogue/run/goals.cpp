// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/robots/inverse_kinematics.hpp>
#include "catalogue/run/ends.hpp"

namespace leastcost {
namespace {

NamedFrame frame_of(const ToolPose& tool, const Robot& robot) {
  try {
    return find_frame(robot, tool.link);
  } catch (const OptionError& error) {
    throw OptionError("ends.target.tool.link", error.reason());
  }
}

ToolGoal goal_of(const ToolPose& tool, const Robot& robot) {
  const int space = robot.kinematics->space();
  const NamedFrame frame = frame_of(tool, robot);
  ToolGoal goal{.link = frame.link, .tool = frame.place.origin};
  if (tool.offset.size() > 0) {
    if (tool.offset.size() != space || !tool.offset.allFinite())
      throw OptionError("ends.target.tool.offset", fmt::format("must be {} finite numbers", space));
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    offset.head(space) = tool.offset;
    goal.tool = frame.place.at(offset);
  }
  Eigen::Isometry3d pose;
  try {
    pose = pose_of(tool.pose, space);
  } catch (const OptionError& error) {  // "pose.rpy"
    const std::string& key = error.key();
    throw OptionError("ends.target.tool" + key.substr(std::min(key.size(), std::string("pose").size())),
                      error.reason());
  }
  goal.position = pose.translation();
  const ShapePose& given = tool.pose;
  if (given.rpy.size() > 0 || given.quaternion.size() > 0 || given.rotation.size() > 0 || given.angle)
    goal.rotation = pose.linear() * frame.place.rotation.transpose();
  return goal;
}

std::vector<PlacedEnd> configurations_of(const ToolPose& tool, const Robot* robot, const RunParts& out) {
  if (robot == nullptr) throw OptionError("ends.target.tool", "needs a robot: give 'robot', or {point: [..]}");
  const Kinematics& kinematics = *robot->kinematics;
  const ToolGoal goal = goal_of(tool, *robot);
  const auto free = [&](const Eigen::VectorXd& x) { return why_in_clearance(out.problem, {x}).empty(); };
  const auto found = inverse_kinematics(kinematics, goal, out.problem.source.u, free);
  if (found.empty()) {
    const auto any = [](const Eigen::VectorXd&) { return true; };
    const bool reached = !inverse_kinematics(kinematics, goal, out.problem.source.u, any).empty();
    throw OptionError("ends.target.tool",
                      reached ? "every configuration that was found for this pose touches an obstacle, or the robot "
                                "itself: move the pose, or lower 'clearance'"
                              : "no configuration within the joint limits was found that brings the tool there: "
                                "check that it is within reach, or leave out the rotation");
  }
  std::vector<PlacedEnd> ends;
  ends.reserve(found.size());
  for (const Eigen::VectorXd& x : found) ends.push_back({x, {x}, 0});
  return ends;
}

/// The source among several goals: a path to it has no length, and another goal was meant as well. Where all of them
/// are the source, the caller says so.
void leave_out_source(std::vector<PlacedEnd>& goals, RunParts& out) {
  std::vector<PlacedEnd> others;
  for (const PlacedEnd& goal : goals) {
    Problem problem = out.problem;
    problem.target = goal.end;
    if (!are_one_place(problem)) others.push_back(goal);
  }
  if (others.empty() || others.size() == goals.size()) return;
  goals = std::move(others);
  out.notes.emplace_back("the source itself is among the goals of the target, and was left out");
}

std::vector<PlacedEnd> free_points(const Eigen::MatrixXd& points, const ConstraintManifold& open_domain,
                                   RunParts& out) {
  std::vector<PlacedEnd> ends;
  std::string first_why;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const EndOptions one{.point = Eigen::VectorXd(points.row(i))};
    PlacedEnd placed = place_end(open_domain, one, "ends.target");
    refuse_many_turns(out, placed.end, "ends.target.points");
    const std::string why = why_in_clearance(out.problem, placed.end);
    if (why.empty()) {
      ends.push_back(std::move(placed));
      continue;
    }
    out.notes.push_back(fmt::format("goal {} of the target was left out: it {}", i + 1, why));
    if (first_why.empty()) first_why = why;
  }
  if (ends.empty())
    throw OptionError("ends.target.points", "end_in_clearance: none of them is free: the first one " + first_why);
  return ends;
}

}  // namespace

std::vector<PlacedEnd> goals_of(const EndOptions& options, const Robot* robot, const ConstraintManifold& open_domain,
                                RunParts& out) {
  std::vector<PlacedEnd> all =
      options.points ? free_points(*options.points, open_domain, out) : configurations_of(options.tool, robot, out);
  leave_out_source(all, out);
  const Eigen::VectorXd& source = out.problem.source.u;
  std::stable_sort(all.begin(), all.end(), [&](const PlacedEnd& a, const PlacedEnd& b) {
    return (a.end.u - source).squaredNorm() < (b.end.u - source).squaredNorm();
  });
  if (options.tool.given())
    out.notes.push_back(fmt::format("configurations that bring the tool to its pose, tried as goals: {}", all.size()));
  return all;
}

}  // namespace leastcost
