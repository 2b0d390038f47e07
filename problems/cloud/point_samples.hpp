// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Points sampled from a surface, as a reader hands them over: finite, no two equal.
struct PointSamples {
  std::vector<Eigen::Vector3d> positions;  ///< of the points of the file
  std::vector<Eigen::Vector3d> normals;    ///< of unit length, one per position, or empty
  std::vector<std::int32_t> in_file;       ///< number of each point in its file, counted from 0; empty: 0, 1, 2, ...
  std::int32_t count_in_file = 0;          ///< points of the file, those removed included; 0: as many as positions
  std::vector<std::string> notes;          ///< for the report: what was removed
  std::string source = "point cloud";      ///< file, for messages
};

}  // namespace leastcost
