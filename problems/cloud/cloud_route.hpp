// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/cloud/has_point_cloud.hpp>

namespace leastcost {

/// A path from the source to the target along the neighbour graph.
struct CloudRoute {
  std::vector<Eigen::Vector3d> points;  ///< the ends and, in between, samples projected onto the surface
  int vertices = 0;                     ///< samples among them
};

/// The least-cost path of the problem along the neighbour graph under its own segment cost. The ends are joined to
/// their nearest samples. Moves of infinite cost, samples that have no projection onto the surface (borders, outliers)
/// and moves over a hole are not passed. Throws InitializationError where there is no path, with the sizes of the parts
/// or what was reached.
CloudRoute cloud_route(const Problem& problem, const HasPointCloud& domain, const Monitor& monitor);

}  // namespace leastcost
