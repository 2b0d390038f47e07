// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// A polygon in the plane, convex or not, with its inside. Its corners are sharp: it asks for a clearance.
struct PolygonOptions {
  Eigen::MatrixXd corners = {};  ///< m x 2, in order; the last is joined to the first
  void fields(FieldVisitor& visit);
};

/// Throws OptionError for fewer than three corners, two alike in a row, and edges that cross.
std::shared_ptr<const Obstacle> make_polygon(const PolygonOptions& options);

}  // namespace leastcost
