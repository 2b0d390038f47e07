// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/occupancy/occupancy_grid.hpp>

namespace leastcost {

/// What becomes of cells that a map does not know.
enum class UnknownCells { blocked, free };
Words<UnknownCells> words(UnknownCells);

/// A map file, and how it lies in the plane. A map_server file brings all but `unknown` itself.
struct OccupancyOptions {
  std::string file = {};
  double cell = 1;                                    ///< side of a cell, length units
  Eigen::VectorXd origin = Eigen::VectorXd::Zero(2);  ///< of the map's lower corner
  bool negate = false;
  double occupied_thresh = 0.65, free_thresh = 0.196;
  UnknownCells unknown = UnknownCells::blocked;
  void fields(FieldVisitor& visit);
};

/// A grid without cells that lies as the options say. Throws OptionError for what cannot be.
OccupancyGrid placed_grid(const OccupancyOptions& options);

}  // namespace leastcost
