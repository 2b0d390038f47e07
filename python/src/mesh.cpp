// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/mesh.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>

namespace leastcost::python {
namespace {

PolygonSoup soup_of(const Mesh::Vertices& vertices, const Mesh::Faces& faces) {
  PolygonSoup soup;
  soup.source = "arrays";
  const auto v = vertices.unchecked<2>();
  soup.positions.reserve(static_cast<std::size_t>(v.shape(0)));
  for (pybind11::ssize_t i = 0; i < v.shape(0); ++i) soup.positions.emplace_back(v(i, 0), v(i, 1), v(i, 2));
  soup.corners.assign(faces.data(), faces.data() + faces.size());
  const std::int32_t sides = static_cast<std::int32_t>(faces.shape(1));
  for (pybind11::ssize_t f = 0; f <= faces.shape(0); ++f)
    soup.polygon_begin.push_back(static_cast<std::int32_t>(f) * sides);
  return soup;
}

std::string text_of(const TriangleMesh& mesh, const SurfacePoint& p) {
  if (const std::int32_t v = vertex_at(mesh, p); v >= 0) return "vertex " + std::to_string(mesh.file_vertex(v));
  return "a point of face " + std::to_string(mesh.file_face(p.face));
}

}  // namespace

Mesh::Mesh(const Vertices& vertices, const Faces& faces, bool weld, const Deadline& deadline)
    : Mesh(soup_of(vertices, faces), weld, deadline) {}

Mesh::Mesh(const std::filesystem::path& file, bool weld, const Deadline& deadline)
    : Mesh(read_mesh(file, deadline), weld, deadline) {}

Mesh::Mesh(PolygonSoup soup, bool weld, const Deadline& deadline)
    : soup_(std::move(soup)),
      weld_(weld),
      manifold_(std::make_shared<MeshManifold>(TriangleMesh(soup_, {.weld = weld, .deadline = deadline}))),
      exact_(mesh(), deadline) {}

Eigen::Matrix3Xd Mesh::vertices() const {
  Eigen::Matrix3Xd out(3, static_cast<Eigen::Index>(soup_.positions.size()));
  for (std::size_t i = 0; i < soup_.positions.size(); ++i) out.col(static_cast<Eigen::Index>(i)) = soup_.positions[i];
  return out;
}

Eigen::Matrix<std::int32_t, 3, Eigen::Dynamic> Mesh::faces() const {
  Eigen::Matrix<std::int32_t, 3, Eigen::Dynamic> out(3, mesh().face_count());
  for (std::int32_t f = 0; f < mesh().face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) out(static_cast<Eigen::Index>(k), f) = mesh().file_vertex(mesh().face(f)[k]);
  return out;
}

SurfacePoint Mesh::vertex(std::int64_t v) const {
  if (v < 0 || v >= mesh().file_vertex_count())
    throw InputError("there is no vertex " + std::to_string(v) + ": vertices are numbered from 0 to " +
                     std::to_string(mesh().file_vertex_count() - 1));
  const std::int32_t own = mesh().vertex_of_file(static_cast<std::int32_t>(v));
  if (own < 0) throw InputError("vertex " + std::to_string(v) + " belongs to no face");
  return vertex_point(mesh(), own);
}

SurfacePoint Mesh::on_face(std::int64_t face, const Eigen::Vector3d& barycentric) const {
  const auto number = static_cast<int>(std::clamp<std::int64_t>(face, -1, std::numeric_limits<int>::max()));
  try {
    manifold_->on_face(number, barycentric);  // says what is wrong
    return mesh().locate(number, barycentric);
  } catch (const OptionError& e) {
    throw InputError(e.what());
  }
}

SurfacePoint Mesh::nearest(const Eigen::Vector3d& point, const Deadline& deadline) const {
  if (!point.allFinite()) throw InputError("a point of the mesh must be finite");
  manifold_->make(deadline);
  const SurfacePoint where = manifold_->tree().nearest(point).where;
  if (where.face < 0) throw InputError("a point is too far from the mesh for its numbers");
  return where;
}

ExactResult Mesh::geodesic(const SurfacePoint& source, const SurfacePoint& target, const Stop& stop) const {
  Workspace workspace = borrow();  // not given back by an exception: it may be in any state
  const Geodesic first = workspace.routes.shortest(source, target, {.stop = stop, .routes = 1});
  if (!first.found() && !(stop && stop()))
    throw InitializationError("there is no path on the mesh from " + text_of(mesh(), source) + " to " +
                              text_of(mesh(), target));
  const SurfacePath* start = first.found() ? &first.result.path : nullptr;
  ExactResult found = exact_.shortest(source, target, workspace.exact, {.stop = stop, .start = start});
  give_back(std::move(workspace));
  return found;
}

ExactDistances Mesh::distances(std::span<const SurfacePoint> sources, double max_distance, const Stop& stop) const {
  Workspace workspace = borrow();
  ExactDistances found = exact_.distances(sources, workspace.exact, {.stop = stop, .max_distance = max_distance});
  give_back(std::move(workspace));
  return found;
}

Mesh::Workspace Mesh::borrow() const {
  const std::scoped_lock lock(mutex_);
  if (idle_.empty()) return {ExactSearch::Workspace(exact_), GeodesicSearch(mesh())};
  Workspace last = std::move(idle_.back());
  idle_.pop_back();
  return last;
}

void Mesh::give_back(Workspace workspace) const {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(workspace));
}

}  // namespace leastcost::python
