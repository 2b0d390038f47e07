// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/initializers/dijkstra.hpp"

#include <optional>
#include <utility>

#include "framework/errors.hpp"
#include "problems/geometry/cloud_route.hpp"
#include "problems/geometry/edge_graph.hpp"
#include "problems/geometry/edge_route.hpp"
#include "problems/geometry/geodesic.hpp"
#include "problems/geometry/mesh_curve.hpp"

namespace leastcost {

namespace {

struct Route {
  SurfacePath path;
  int graph_vertices = 0;
};

Route along_edges(const Problem& problem, const TriangleMesh& mesh, const SurfacePoint& source,
                  const SurfacePoint& target, const Monitor& monitor) {
  EdgeGraphSearch search(mesh);
  EdgePath route = edge_route(problem, mesh, search, source, target, monitor);
  const int vertices = static_cast<int>(route.path.points.size()) - 2;
  return {std::move(route.path), vertices};
}

Route best_straightened(const Problem& problem, const TriangleMesh& mesh, const SurfacePoint& source,
                        const SurfacePoint& target, int routes, const Monitor& monitor) {
  const std::optional<MetricRoot> metric = constant_metric(problem);
  if (!metric)
    throw InputError(
        "dijkstra with more than one route straightens them, which needs a cost with a constant metric "
        "(euclidean, metric_tensor); use routes: 1");
  GeodesicOptions options{.metric = *metric, .stop = [&monitor] { return monitor.interrupted(); }, .routes = routes};
  Geodesic best = GeodesicSearch(mesh).shortest(source, target, options);
  if (!best.found()) throw InitializationError(best.first.failure());
  const int vertices = static_cast<int>(best.first.path.points.size()) - 2;
  return {std::move(best.result.path), vertices};
}

FirstPath along_cloud(const Problem& problem, const HasPointCloud& domain, int routes, const Monitor& monitor) {
  if (routes > 1) throw InputError("dijkstra with more than one route needs a mesh; use routes: 1 on a point cloud");
  const CloudRoute route = cloud_route(problem, domain, monitor);
  FirstPath first;
  first.path.u.resize(3, static_cast<Index>(route.points.size()));
  for (std::size_t i = 0; i < route.points.size(); ++i) first.path.u.col(static_cast<Index>(i)) = route.points[i];
  first.graph_vertices = route.vertices;
  return first;
}

}  // namespace

void DijkstraOptions::fields(FieldVisitor& visit) {
  visit.field("routes", routes,
              {.help = "1: the least-cost edge path. 2: the better of two straightened graph paths, for costs with a "
                       "constant metric.",
               .minimum = 1,
               .maximum = 2});
}

FirstPath DijkstraInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  if (const auto* cloud = dynamic_cast<const HasPointCloud*>(problem.manifold.get()))
    return along_cloud(problem, *cloud, options_.routes, monitor);
  const TriangleMesh& mesh = mesh_of(problem, "initializer dijkstra").mesh();
  const SurfacePoint source = point_on_face(mesh, problem.source.site, problem.source.u);
  const SurfacePoint target = point_on_face(mesh, problem.target.site, problem.target.u);
  Route route = options_.routes > 1 ? best_straightened(problem, mesh, source, target, options_.routes, monitor)
                                    : along_edges(problem, mesh, source, target, monitor);
  FirstPath first;
  first.path = as_coordinates(route.path);
  first.graph_vertices = route.graph_vertices;
  return first;
}

}  // namespace leastcost
