// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/mesh_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "problems/fields/no_way.hpp"
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost::app {
namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();

const TriangleMesh& mesh_with_length(const Problem& problem) {
  const TriangleMesh& mesh = mesh_of(problem, "field").mesh();
  const std::optional<MetricRoot> metric = constant_metric(problem);
  if (!metric || *metric)
    throw InputError("field: on a mesh the values are lengths: the configuration needs cost: euclidean");
  return mesh;
}

}  // namespace

MeshFields::MeshFields(const Problem& problem, const Stop& stop)
    : domain_(problem.manifold), mesh_(mesh_with_length(problem)), search_(mesh_, Deadline({}, stop)) {}

SurfacePoint MeshFields::point(const PathEnd& place) const {
  return point_on_face(mesh_, place.site, in_space(place.u));
}

MeshField MeshFields::from(std::vector<SurfacePoint> places, const Stop& stop) const {
  ExactOptions options;
  options.stop = stop;
  ExactSearch::Workspace workspace(search_);
  const ExactDistances found = search_.distances(places, workspace, options);
  if (found.stopped && !found.out_of_memory) throw Interrupted("field: interrupted before all vertices were reached");
  MeshField field;
  field.places = std::move(places);
  field.cut = !found.complete;
  field.values.reserve(found.distance.size());
  field.errors.reserve(found.distance.size());
  for (std::size_t v = 0; v < found.distance.size(); ++v) {
    const double most = found.at_most[v];
    const bool seen = found.at_least[v] < found.seen_to;  // else the value is known from above alone
    field.values.push_back(most < kUnreachable ? (seen ? found.distance[v] : most) : std::nan(""));
    field.errors.push_back(most < kUnreachable ? most - found.at_least[v] : 0);
  }
  return field;
}

SurfacePath MeshFields::way(std::span<const SurfacePoint> places, const SurfacePoint& to, const Stop& stop) const {
  const Eigen::Vector3d there = mesh_.point(to);
  std::vector<std::pair<double, const SurfacePoint*>> order;  // a straight line is no longer than a path
  for (const SurfacePoint& place : places) order.emplace_back((mesh_.point(place) - there).norm(), &place);
  std::sort(order.begin(), order.end());
  ExactSearch::Workspace workspace(search_);
  ExactOptions options;
  options.stop = stop;
  ExactResult best;
  for (const auto& [straight, place] : order) {
    if (straight >= best.length) break;
    ExactResult found = search_.shortest(*place, to, workspace, options);
    if (stop && stop()) throw Interrupted("field: interrupted before the path was found");
    if (found.length < best.length) best = std::move(found);
  }
  if (!(best.length < kUnreachable)) throw NoWay("no path on the mesh leads there");
  return std::move(best.path);
}

MeshField corridor(const MeshField& from, const MeshField& to, double least) {
  MeshField sum = from;
  sum.places.insert(sum.places.end(), to.places.begin(), to.places.end());
  sum.cut = from.cut || to.cut;
  for (std::size_t v = 0; v < sum.values.size(); ++v) {
    sum.values[v] = sum.values[v] + to.values[v] - least;
    sum.errors[v] += to.errors[v];
    if (sum.values[v] < 0) sum.values[v] = 0;  // by rounding
  }
  return sum;
}

std::vector<double> in_order_of_file(const TriangleMesh& mesh, const MeshField& field) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(mesh.file_vertex_count()));
  for (std::int32_t v = 0; v < mesh.file_vertex_count(); ++v) {
    const std::int32_t own = mesh.vertex_of_file(v);
    values.push_back(own < 0 ? std::nan("") : field.values[static_cast<std::size_t>(own)]);
  }
  return values;
}

}  // namespace leastcost::app
