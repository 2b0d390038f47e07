// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/edge_route.hpp"

#include <cmath>
#include <optional>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/mesh/length_search.hpp>
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost {

EdgePath found_or_throw(EdgePath route, const std::string& reason) {
  if (route.outcome == EdgePathOutcome::stopped) throw Interrupted(route.failure());
  if (!route.found()) throw InitializationError(route.failure() + reason);
  return route;
}

EdgePath edge_route(const Problem& problem, const TriangleMesh& mesh, const SurfacePoint& source,
                    const SurfacePoint& target, const Monitor& monitor) {
  const auto stop = [&monitor] { return monitor.interrupted(); };
  if (const std::optional<MetricRoot> metric = constant_metric(problem))
    return found_or_throw(LengthSearch(mesh).shortest(source, target, {.metric = *metric, .stop = stop}));
  const SegmentCost& cost = *problem.cost;
  // The ends as they were given: barycentric rounding may lift them above the level of a bead at rest.
  const auto exact = [&problem, near = 1e-13 * mesh.diameter()](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    for (const PathEnd* end : {&problem.source, &problem.target})
      if (end->u.size() > 0 && (p - in_space(end->u)).norm() <= near) return in_space(end->u);
    return p;
  };
  std::string reason;  // of the first move that costs infinitely much
  const auto move = [&cost, &exact, &reason, rows = problem.manifold->dimensions().ambient](const Eigen::Vector3d& a,
                                                                                            const Eigen::Vector3d& b) {
    Points ends(rows, 2);
    ends << exact(a).head(rows), exact(b).head(rows);
    double q = 0;
    cost.squared_costs({{ends.data(), rows, 2}, {}, false}, {&q, 1});
    if (reason.empty() && std::isinf(q)) reason = reason_for_infinity(cost, ends.col(0), ends.col(1));
    return std::sqrt(q);
  };
  EdgePathOptions options;
  options.stop = stop;
  // A chord that is below every curve is admissible, and consistent by the triangle inequality.
  if (cost.traits().below_curves)
    options.lower_bound = [&move, goal = mesh.point(target)](const Eigen::Vector3d& p) { return move(p, goal); };
  return found_or_throw(EdgeGraphSearch(mesh).shortest(source, target, move, options), reason);
}

}  // namespace leastcost
