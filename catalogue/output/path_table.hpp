// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/replan/waypoints.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// A polyline of a result with its costs, ready to be written in any format.
struct PathTable {
  Points x;                              ///< ambient, d x m
  std::vector<std::string> x_names;      ///< of these coordinates
  Points chart;                          ///< their coordinates in a chart, one column per point; empty without one
  std::vector<std::string> chart_names;  ///< of these coordinates
  bool ring = false;                     ///< a move leads from the last column to the first
  Eigen::VectorXd
      segment_costs;  ///< from each point to the next, along the curve on the domain; 0 at the end of an open path
  Eigen::VectorXd cumulative_costs;  ///< from the first point
  std::vector<Site> segment_sites;   ///< of a delivered curve: the pieces that carry its segments; may be empty
  /// Where each point is in the file that the domain was read from, one column per point (HasFilePlaces); may be empty.
  Points places;
  std::vector<std::string> place_names;  ///< one per row of these
  Points configurations;                 ///< of a robot, where x has the way of its hand in their place; else empty
};

/// The delivered points.
PathTable delivered_points(const Problem& problem, const Result& result);
/// The delivered curve; its places are on the pieces that carry the segments which start at the points.
PathTable delivered_curve(const Problem& problem, const Result& result);
/// The waypoints; costs are of the path. Where they are times, `time` is a column of its own.
PathTable waypoint_table(const Problem& problem, const Waypoints& waypoints);

/// index, ambient coordinates, in a chart also those of the chart, segment_cost, cumulative_cost, and where the domain
/// knows them the places in its file. All digits.
std::string csv_text(const PathTable& table);

/// first_path.csv: index, ambient coordinates, in a chart also those of the chart, of the first path as its initializer
/// made it.
std::string first_path_csv(const Problem& problem, const FirstPath& first);

/// residuals.csv: cumulative_cost, at_point, between - how far the points of the delivered curve lie off the domain,
/// and the middles of its segments; length units. Nothing where the question has no meaning: on flat domains and in
/// charts.
std::string residuals_csv(const Problem& problem, const PathTable& curve);

/// What a polyline of path.vtp is.
enum class VtpPart : int {
  chords = 0,    ///< the straight moves between the points, which leave a curved domain
  curve = 1,     ///< the path on the domain, whose cost is printed
  other_way = 2  ///< the curve of another member of the family
};

/// VTK XML PolyData (ASCII), one polyline for each line, told apart by the cell arrays `part` (of VtpPart) and `line`
/// (their number). Above three dimensions, and of a robot, the array `coordinates` has all of them.
std::string vtp_text(const std::vector<PathTable>& lines, const std::vector<VtpPart>& parts);

/// Wavefront OBJ with one polyline.
std::string obj_text(const PathTable& table);

/// iteration, energy, cost_error, step, evaluations, seconds.
std::string history_csv(const std::vector<Iteration>& history);

}  // namespace leastcost
