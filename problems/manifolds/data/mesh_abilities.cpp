// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a mesh can do besides being a domain: the search along its edges, places in its file, its picture.
#include <cmath>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include "problems/drawing/domain_shapes.hpp"
#include "problems/mesh/edge_route.hpp"
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost {
namespace {

PathEnd end_at(const TriangleMesh& mesh, const SurfacePoint& p) { return {mesh.point(p), p.face}; }

}  // namespace

FirstPath MeshManifold::least_cost_edges(const Problem& problem, const Monitor& monitor) const {
  const SurfacePoint source = point_on_face(mesh_, problem.source.site, problem.source.u);
  const SurfacePoint target = point_on_face(mesh_, problem.target.site, problem.target.u);
  const EdgePath route = edge_route(problem, mesh_, source, target, monitor);
  FirstPath first;
  first.path = as_coordinates(problem, route.path);
  first.graph_vertices = static_cast<int>(route.path.points.size()) - 2;
  return first;
}

PathEnd MeshManifold::vertex(int number) const {
  if (number < 0 || number >= mesh_.file_vertex_count())
    throw OptionError("vertex", "the mesh has vertices 0 to " + std::to_string(mesh_.file_vertex_count() - 1) +
                                    ", not " + std::to_string(number));
  const std::int32_t here = mesh_.vertex_of_file(number);
  if (here < 0) throw OptionError("vertex", "no face of the mesh uses vertex " + std::to_string(number));
  return end_at(mesh_, vertex_point(mesh_, here));
}

PathEnd MeshManifold::on_face(int face, const Eigen::Vector3d& barycentric) const {
  if (face < 0 || face >= mesh_.file_face_count())
    throw OptionError("face", "the mesh has faces 0 to " + std::to_string(mesh_.file_face_count() - 1) + ", not " +
                                  std::to_string(face));
  const double sum = barycentric.sum();
  constexpr double kRounding = 1e-6;  // what locate() forgives
  if (!(std::abs(sum - 1) <= kRounding)) {
    std::ostringstream why;
    why.precision(9);
    why << "the three weights must have sum 1, not " << sum;
    throw OptionError("barycentric", why.str());
  }
  try {
    return end_at(mesh_, mesh_.locate(face, barycentric));
  } catch (const InputError& e) {
    throw OptionError("face", e.what());
  }
}

std::vector<std::string> MeshManifold::place_columns() const {
  return {"face", "fan", "v0", "v1", "v2", "b0", "b1", "b2"};
}

Eigen::VectorXd MeshManifold::place_in_file(Site site, const Eigen::VectorXd& x) const {
  const TriangleMesh::FilePoint p = site < 0 ? TriangleMesh::FilePoint{} : mesh_.in_file(point_on_face(mesh_, site, x));
  Eigen::VectorXd place(8);
  place << p.face, p.fan, p.vertices[0], p.vertices[1], p.vertices[2], p.barycentric;
  return place;
}

std::vector<DataCount> MeshManifold::counts() const {
  return {{"vertex", "vertices", mesh_.vertex_count()},
          {"face", "faces", mesh_.face_count()},
          {"component", "components", static_cast<long>(mesh_.component_sizes().size())}};
}

void MeshManifold::draw(const DrawnPaths& paths, Drawing& out) const {
  TriangleSoup all{mesh_.positions(), {}};
  for (const auto& [a, b, c] : mesh_.faces()) all.triangles.push_back({a, b, c});
  out.surface = data_surface(std::move(all), paths.x, out.notes);
  out.up = up_of_data(out.surface.vertices);
}

}  // namespace leastcost
