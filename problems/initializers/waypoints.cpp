// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/waypoints.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include "framework/domain/in_parts.hpp"
#include "problems/mesh/edge_route.hpp"
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost {
namespace {

/// Appends `more` to `path`; its first column is the last one of `path` and takes its place.
void append(CoordinatePath& path, const CoordinatePath& more) {
  const Index old = path.u.cols() > 0 ? path.u.cols() - 1 : 0;
  path.u.conservativeResize(more.u.rows(), old + more.u.cols());
  path.u.rightCols(more.u.cols()) = more.u;
  path.sites.resize(static_cast<std::size_t>(old));
  path.sites.insert(path.sites.end(), more.sites.begin(), more.sites.end());
}

/// Where coordinates are names only (longitudes of a sphere), each stop by the name nearest to the stop before it.
void name_in_turn(const ConstraintManifold& domain, Index end, Points& stops) {
  const auto* names = find_ability<HasImages>(domain);
  if (names == nullptr) return;
  for (Index i = 1; i < end; ++i) stops.col(i) = names->nearest_name(stops.col(i), stops.col(i - 1));
}

/// Stops of the tour: source, waypoints, target; in a ring the waypoints and the first one again.
CoordinatePath stops(const Problem& problem, const Points& waypoints, const Monitor& monitor) {
  CoordinatePath path{waypoints, {}, true};
  const Projection projection = project(*problem.manifold, path, monitor.limit());
  if (!projection.failed.empty())
    throw InitializationError("waypoint " + std::to_string(projection.failed.front()) +
                              " (numbered from 0) has no nearest point on the domain");
  CoordinatePath all{Points(waypoints.rows(), waypoints.cols() + (problem.ring ? 1 : 2)), {}, false};
  if (problem.ring)
    all.u << path.u, path.u.col(0);
  else
    all.u << problem.source.u, path.u, problem.target.u;
  // Of a ring the first point again is named when it closes across a seam. The target of an open path keeps the name
  // that the problem has for it.
  name_in_turn(*problem.manifold, all.u.cols() - 1, all.u);
  if (path.sites.empty()) return all;
  all.sites = path.sites;
  if (problem.ring) {
    all.sites.push_back(path.sites.front());
  } else {
    all.sites.insert(all.sites.begin(), problem.source.site);
    all.sites.push_back(problem.target.site);
  }
  return all;
}

CoordinatePath join_on_mesh(const Problem& problem, const TriangleMesh& mesh, const CoordinatePath& stops,
                            const Monitor& monitor) {
  const std::vector<SurfacePoint> points = surface_points(mesh, stops);
  CoordinatePath path;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (stops.u.col(static_cast<Index>(i)) == stops.u.col(static_cast<Index>(i) + 1)) continue;
    append(path, as_coordinates(problem, edge_route(problem, mesh, points[i], points[i + 1], monitor).path));
  }
  return path;
}

/// On a chart with seams the ring closes on the image of its first point that is nearest to the last one, which may
/// also be given.
void close_across_seams(const HasSeams& domain, CoordinatePath& ring) {
  const Index last = ring.u.cols() - 1;
  const Eigen::VectorXi turns = nearest_image(domain.seams(), ring.u.col(0), ring.u.col(last));
  if (turns.isZero()) return;
  ring.closing = seam_map(domain.seams(), static_cast<int>(ring.u.rows()), turns);
  if ((ring.column(last + 1) - ring.u.col(last)).norm() <= 1e-9 * (1 + ring.u.col(last).norm()))
    ring.u.conservativeResize(Eigen::NoChange, last);
}

}  // namespace

void WaypointsOptions::fields(FieldVisitor& visit) {
  visit.field("points", points,
              {.help = "Points to pass through, one row each, in order.", .unit = "length", .required = true});
}

void FileInitializerOptions::fields(FieldVisitor& visit) {
  visit.file("file", file,
             {.help = "Text file with one point per row, such as the path.csv of an earlier run.", .required = true});
}

WaypointsInitializer::WaypointsInitializer(Points waypoints) : waypoints_(std::move(waypoints)) {
  if (waypoints_.cols() == 0) throw OptionError("points", "at least one waypoint is needed");
  if (!waypoints_.allFinite()) throw OptionError("points", "coordinates must be finite");
}

FirstPath WaypointsInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (waypoints_.rows() != problem.manifold->dimensions().coordinate)
    throw OptionError("points", "waypoints have " + std::to_string(waypoints_.rows()) +
                                    " coordinates, but the domain has " +
                                    std::to_string(problem.manifold->dimensions().coordinate));
  if (problem.ring && waypoints_.cols() < 3) throw OptionError("points", "a ring needs at least 3 waypoints");
  FirstPath first;
  first.path = stops(problem, waypoints_, monitor);
  if (const auto* domain = find_ability<HasMesh>(*problem.manifold)) {
    first.path = join_on_mesh(problem, domain->mesh(), first.path, monitor);
    first.graph_vertices = static_cast<int>(first.path.u.cols()) - 2;
  }
  if (!problem.ring) pin_ends(problem, first.path);
  if (problem.ring) {  // the closing point is the first one again
    first.path.ring = true;
    first.path.u.conservativeResize(Eigen::NoChange, first.path.u.cols() - 1);
    if (!first.path.sites.empty()) first.path.sites.pop_back();
    if (const auto* seams = find_ability<HasSeams>(*problem.manifold)) close_across_seams(*seams, first.path);
  }
  return first;
}

}  // namespace leastcost
