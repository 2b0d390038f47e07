// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// A mesh as the search takes it.
struct ClickedMesh {
  int too_large = 0;  ///< how many triangles, if they are too many; then nothing else is here
  std::vector<double> vertices;
  std::vector<std::int32_t> triangles;
  /// The numbers of the vertices in their file, -1 where it has none; empty: they are the same.
  std::vector<std::int32_t> numbers;
};

/// Obstacles in the plane by the corners of their cores (one: a ball), and what is required around each.
struct ClickedPlan {
  int too_large = 0;  ///< how many obstacles, if they are too many; then nothing else is here
  std::vector<double> corners;
  std::vector<int> counts;  ///< of corners
  std::vector<double> required;
  Eigen::VectorXd lower, upper;  ///< of the box that paths stay in; empty: none
};

/// What shortest paths between other ends of a problem need, for those who search them elsewhere: in a report. At most
/// one of the two; neither where the cost is not the length, on other domains, and among other obstacles.
struct ClickData {
  std::optional<ClickedMesh> mesh;
  std::optional<ClickedPlan> plan;
};

/// Triangles up to which a report answers: its page gets a few megabytes, and the tables of the search 200 MB.
inline constexpr int kMostClickedTriangles = 200000;
/// The same of obstacles in the plane.
inline constexpr int kMostClickedObstacles = 5000;

ClickData click_data(const Problem& problem);

}  // namespace leastcost
