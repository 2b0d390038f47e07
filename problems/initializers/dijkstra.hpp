// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct DijkstraOptions {
  int routes = 1;
  int rank = 1;
  bool diagonals = false;
  int landmarks = 0;
  void fields(FieldVisitor& visit);
};

class RouteKeeper;

/// The least-cost path along mesh edges or along the neighbour graph of a point cloud, weighed by the run's own segment
/// cost (VFCS 4.4.1), through Boost.Graph. With `routes: 2` the better of two straightened graph paths
/// (GeodesicSearch): a better guess at the class of the shortest path, for costs with a constant metric. With `rank: k`
/// the k-th of routes of which each keeps away from those before it: a start for another class of paths. With
/// `diagonals` also straight across one edge. With `landmarks` quicker on large meshes (EdgeLandmarks): made by the
/// first query on a mesh and kept by the object and its copies, which threads may share. Throws InputError where the
/// domain has no graph (routes: 2, diagonals, landmarks: is no mesh) or the cost has no such metric.
class DijkstraInitializer final : public Initializer {
 public:
  explicit DijkstraInitializer(DijkstraOptions options = {});
  std::string_view name() const override { return "dijkstra"; }
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  DijkstraOptions options_;
  std::shared_ptr<RouteKeeper> keeper_;
};

}  // namespace leastcost
