// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/find_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// A polyline of a result with its costs, ready to be written in any format.
struct PathTable {
  Points x;           ///< ambient, d x m
  Points chart;       ///< their coordinates in a chart, one column per point; empty without one
  bool ring = false;  ///< a move leads from the last column to the first
  Eigen::VectorXd
      segment_costs;  ///< from each point to the next, along the curve on the domain; 0 at the end of an open path
  Eigen::VectorXd cumulative_costs;              ///< from the first point
  std::vector<TriangleMesh::FilePoint> on_mesh;  ///< where each point is, in terms of the file; empty off meshes
};

/// The delivered points.
PathTable delivered_points(const Problem& problem, const Result& result);
/// The delivered curve; `on_mesh` names the face that carries the segment which starts at a point.
PathTable delivered_curve(const Problem& problem, const Result& result);

/// index, ambient coordinates, in a chart also u and v, segment_cost, cumulative_cost; on a mesh also face, fan, the
/// corners v0 v1 v2 of the triangle and the barycentric coordinates b0 b1 b2, all numbered as in the file. All digits.
std::string csv_text(const PathTable& table);

/// first_path.csv: index, ambient coordinates, in a chart also u and v, of the first path as its initializer made it.
std::string first_path_csv(const Problem& problem, const FirstPath& first);

/// residuals.csv: cumulative_cost, at_point, between - how far the points of the delivered curve lie off the domain,
/// and the middles of its segments; length units. Nothing where the question has no meaning: on flat domains and in
/// charts.
std::string residuals_csv(const Problem& problem, const PathTable& curve);

/// VTK XML PolyData (ASCII): the points and, where it differs, the curve on the domain, as one polyline each, told
/// apart by the cell array `line` (0: points, 1: curve). Above three dimensions the array `coordinates` has all of
/// them.
std::string vtp_text(const std::vector<PathTable>& lines);

/// Wavefront OBJ with one polyline.
std::string obj_text(const PathTable& table);

/// iteration, energy, cost_error, step, evaluations, seconds.
std::string history_csv(const std::vector<Iteration>& history);

}  // namespace leastcost
