// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/edge_route.hpp"

#include <cmath>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/segment_cost.hpp>
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost {

EdgePath edge_route(const Problem& problem, const TriangleMesh& mesh, EdgeGraphSearch& search,
                    const SurfacePoint& source, const SurfacePoint& target, const Monitor& monitor) {
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
  options.stop = [&monitor] { return monitor.interrupted(); };
  // A chord that is below every curve is admissible, and consistent by the triangle inequality.
  if (cost.traits().below_curves)
    options.lower_bound = [&move, goal = mesh.point(target)](const Eigen::Vector3d& p) { return move(p, goal); };
  EdgePath route = search.shortest(source, target, move, options);
  if (route.outcome == EdgePathOutcome::stopped) throw Interrupted(route.failure());
  if (!route.found()) throw InitializationError(route.failure() + reason);
  return route;
}

}  // namespace leastcost
