// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/dijkstra.hpp>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/has_graph.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include "problems/initializers/away_from_routes.hpp"
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost {

namespace {

FirstPath best_straightened(const Problem& problem, int routes, const Monitor& monitor) {
  const auto* domain = find_ability<HasMesh>(*problem.manifold);
  if (domain == nullptr)
    throw InputError("dijkstra with more than one route needs a mesh; use routes: 1 on other domains");
  const TriangleMesh& mesh = domain->mesh();
  const SurfacePoint source = point_on_face(mesh, problem.source.site, in_space(problem.source.u));
  const SurfacePoint target = point_on_face(mesh, problem.target.site, in_space(problem.target.u));
  const std::optional<MetricRoot> metric = constant_metric(problem);
  if (!metric)
    throw InputError(
        "dijkstra with more than one route straightens them, which needs a cost with a constant metric "
        "(euclidean, metric_tensor); use routes: 1");
  GeodesicOptions options{.metric = *metric, .stop = [&monitor] { return monitor.interrupted(); }, .routes = routes};
  Geodesic best = GeodesicSearch(mesh).shortest(source, target, options);
  if (best.first.outcome == EdgePathOutcome::stopped) throw Interrupted(best.first.failure());
  if (!best.found()) throw InitializationError(best.first.failure());
  FirstPath first;
  first.path = as_coordinates(problem, best.result.path);
  first.graph_vertices = static_cast<int>(best.first.path.points.size()) - 2;
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
              {.help = "k: the k-th of routes that keep away from each other, for another class of paths.",
               .minimum = 1,
               .maximum = 32});
}

FirstPath DijkstraInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  if (options_.rank > 1 && options_.routes > 1)
    throw OptionError("rank", "goes with routes: 1; the best of two routes has no second best");
  const auto* domain = find_ability<HasGraph>(*problem.manifold);
  if (domain == nullptr) throw InputError("initializer dijkstra needs a domain with a graph: a mesh or a point cloud");
  if (options_.routes > 1) return best_straightened(problem, options_.routes, monitor);
  return ranked(problem, options_.rank, [&](const Problem& p) { return domain->least_cost_edges(p, monitor); });
}

}  // namespace leastcost
