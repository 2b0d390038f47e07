// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/dijkstra.hpp>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include "problems/initializers/away_from_routes.hpp"
#include "problems/initializers/route_keeper.hpp"
#include "problems/mesh/edge_route.hpp"
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost {

namespace {

/// Over a mesh by length: over diagonals too, aimed by landmarks, or the better of two that are straightened.
FirstPath by_length(const Problem& problem, const DijkstraOptions& options, RouteKeeper& keeper,
                    const Monitor& monitor) {
  const auto* domain = find_ability<HasMesh>(*problem.manifold);
  if (domain == nullptr)
    throw InputError("dijkstra with more than one route, diagonals or landmarks needs a mesh; remove them elsewhere");
  const TriangleMesh& mesh = domain->mesh();
  const std::optional<MetricRoot> metric = constant_metric(problem);
  if (!metric)
    throw InputError(
        "dijkstra with more than one route, diagonals or landmarks needs a cost with a constant metric (euclidean, "
        "metric_tensor); remove them");
  const SurfacePoint source = point_on_face(mesh, problem.source.site, in_space(problem.source.u));
  const SurfacePoint target = point_on_face(mesh, problem.target.site, in_space(problem.target.u));
  const StopPredicate stop = [&monitor] { return monitor.interrupted(); };
  const std::shared_ptr<KeptRoutes> kept = keeper.routes_for(problem, mesh, *metric, options.landmarks, stop);
  GeodesicSearch search = kept->borrow();
  SurfacePath path;
  std::size_t points = 0;  // of the path along the graph
  if (options.routes > 1) {
    Geodesic best = search.shortest(
        source, target, {.metric = *metric, .stop = stop, .routes = options.routes, .landmarks = kept->landmarks()});
    points = found_or_throw(std::move(best.first)).path.points.size();
    path = std::move(best.result.path);
  } else {
    path = found_or_throw(
               search.first_path(
                   source, target,
                   {.metric = *metric, .stop = stop, .diagonals = options.diagonals, .landmarks = kept->landmarks()}))
               .path;
    points = path.points.size();
  }
  kept->give_back(std::move(search));
  FirstPath first;
  first.path = as_coordinates(problem, path);
  first.graph_vertices = static_cast<int>(points) - 2;
  return first;
}

double length_of(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

/// The last of `rank` routes; near earlier ones moves cost more.
template <class Find>
FirstPath ranked(const Problem& problem, int rank, Find find) {
  constexpr double kFactor = 4, kReach = 0.3;  // reach: of the length of the first route
  FirstPath first = find(problem);
  std::vector<Points> routes;
  double reach = 0;
  for (int k = 1; k < rank; ++k) {
    routes.push_back(first.path.u);
    if (k == 1) reach = kReach * length_of(first.path.u);
    Problem other = problem;
    other.cost = std::make_shared<const AwayFromRoutes>(problem.cost, routes, kFactor, reach);
    first = find(other);
  }
  return first;
}

}  // namespace

void DijkstraOptions::fields(FieldVisitor& visit) {
  visit.field("routes", routes,
              {.help = "1: the least-cost edge path. 2: the better of two straightened graph paths, for costs with a "
                       "constant metric.",
               .minimum = 1,
               .maximum = 2});
  visit.field("rank", rank,
              {.help = "k: the k-th of several routes that avoid each other, for another class of paths.",
               .minimum = 1,
               .maximum = 32});
  visit.field("diagonals", diagonals,
              {.help = "Also use moves from a mesh vertex across an edge to the opposite vertex, for costs with a "
                       "constant metric. The path is then more often in the class of the shortest one."});
  visit.field(
      "landmarks", landmarks,
      {.help = "Number of mesh vertices whose distances to all others are computed once, to guide every later search, "
               "for costs with a constant metric. Faster for many pairs on a large mesh; each distance takes 4 bytes.",
       .minimum = 0,
       .maximum = 256});
}

DijkstraInitializer::DijkstraInitializer(DijkstraOptions options)
    : options_(checked(options)), keeper_(std::make_shared<RouteKeeper>()) {}

FirstPath DijkstraInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  const bool lengths = options_.routes > 1 || options_.diagonals || options_.landmarks > 0;
  if (options_.rank > 1 && options_.routes > 1) throw OptionError("rank", "needs routes: 1");
  if (options_.rank > 1 && lengths) throw OptionError("rank", "works without diagonals and landmarks only");
  const auto* domain = find_ability<HasGraph>(*problem.manifold);
  if (domain == nullptr) throw InputError("initializer dijkstra needs a domain with a graph: a mesh or a point cloud");
  if (lengths) return by_length(problem, options_, *keeper_, monitor);
  return ranked(problem, options_.rank, [&](const Problem& p) { return domain->least_cost_edges(p, monitor); });
}

}  // namespace leastcost
