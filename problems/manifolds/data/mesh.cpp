// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/data/mesh.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "problems/mesh/weld_option.hpp"

namespace leastcost {
namespace {

/// Barycentric coordinate below which a point counts as lying on an edge.
constexpr double kOnEdge = 1e-9;
constexpr double kOnFace = 1e-14;  // mesh diameters

void orthonormal_to(const Eigen::Vector3d& normal, Eigen::Ref<Points> basis) {
  basis.col(0) = normal.unitOrthogonal();
  basis.col(1) = normal.cross(Eigen::Vector3d(basis.col(0)));
}

/// Outward unit normal, in the plane of its face, of the border edge h.
/// The face of a column. A path without sites is data, not a bug of ours.
std::int32_t face_at(const TriangleMesh& mesh, const CoordinatePath& path, Index column) {
  const Site site = path.site(column);
  if (site < 0 || site >= mesh.face_count())
    throw InputError("point " + std::to_string(column) + " of the path refers to no face of the mesh (" +
                     std::to_string(site) + "): project the path first");
  return site;
}

Eigen::Vector3d outward(const TriangleMesh& mesh, std::int32_t h) {
  const Eigen::Vector3d &a = mesh.position(mesh.tail(h)), &b = mesh.position(mesh.head(h));
  const Eigen::Vector3d& opposite = mesh.position(mesh.head(TriangleMesh::next(h)));
  const Eigen::Vector3d along = (b - a).normalized();
  const Eigen::Vector3d inward = (opposite - a) - along.dot(opposite - a) * along;
  return -inward.normalized();
}

}  // namespace

void MeshManifoldOptions::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "Mesh file: OBJ, OFF, PLY or STL.", .required = true});
  visit_weld(visit, weld, weld_within);
  visit.field("subdivide", subdivide,
              {.help = "Midpoint subdivisions: the same geometry with 4^k as many faces.", .minimum = 0, .maximum = 8});
}

MeshManifold::MeshManifold(TriangleMesh mesh) : mesh_(std::move(mesh)) {}

const ClosestPointTree& MeshManifold::tree() const {
  make({});
  return *tree_;
}

void MeshManifold::make(const Deadline& deadline) const {
  std::call_once(tree_asked_, [&] { tree_.emplace(mesh_, deadline); });
}

bool MeshManifold::is_asked_by(const CoordinatePath& path) const {
  for (Index i = 0; i < path.u.cols(); ++i)
    if (path.u.col(i).allFinite() && !off_own_face(path.u.col(i), path.site(i))) return true;
  return false;
}

/// Distance of a point from the face that it names, where that is rounding: no other is nearer by more than that.
std::optional<double> MeshManifold::off_own_face(const Eigen::Vector3d& p, Site site) const {
  if (site < 0 || site >= mesh_.face_count()) return std::nullopt;
  const double off = (mesh_.point(point_on_face(mesh_, site, p)) - p).norm();
  return off <= kOnFace * mesh_.diameter() ? std::optional(off) : std::nullopt;
}

Projection MeshManifold::project(CoordinatePath& path) const {
  Projection result;
  path.sites.resize(static_cast<std::size_t>(path.u.cols()), kNoSite);
  for (Index i = 0; i < path.u.cols(); ++i) {
    Site& site = path.sites[static_cast<std::size_t>(i)];
    if (!path.u.col(i).allFinite()) {
      result.failed.push_back(i);
      continue;
    }
    if (off_own_face(path.u.col(i), site)) continue;
    const ClosestPoint nearest = tree().nearest(path.u.col(i), site);
    path.u.col(i) = nearest.position;
    site = nearest.where.face;
    result.moved = std::max(result.moved, nearest.distance);
  }
  return result;
}

void MeshManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  bases.resize(3, 2 * path.u.cols());
  for (Index i = 0; i < path.u.cols(); ++i)
    orthonormal_to(mesh_.smooth_normal(point_on_face(mesh_, face_at(mesh_, path, i), path.u.col(i))),
                   bases.middleCols(2 * i, 2));
}

void MeshManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  to.sites.resize(static_cast<std::size_t>(to.u.cols()), kNoSite);
  const ClosestPointTree& tree = this->tree();
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    const ClosestPoint nearest = tree.nearest(from.u.col(first + i) + step.col(i), from.site(first + i));
    to.u.col(first + i) = nearest.position;
    to.sites[static_cast<std::size_t>(first + i)] = nearest.where.face;
  }
}

double MeshManifold::residual(const CoordinatePath& path) const {
  double worst = 0;
  for (Index i = 0; i < path.u.cols(); ++i) {
    const Eigen::Vector3d p = path.u.col(i);
    const std::optional<double> off = off_own_face(p, path.site(i));
    worst = std::max(worst, off ? *off : tree().nearest(p, path.site(i)).distance);
  }
  return worst;
}

int MeshManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  const std::int32_t f = face_at(mesh_, path, column);
  int count = 0;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
  for (std::int32_t k = 0; k < 3; ++k) {
    const std::int32_t h = 3 * f + k;
    if (mesh_.across(h) != TriangleMesh::kBorder) continue;
    if (barycentric.isZero(0)) barycentric = point_on_face(mesh_, f, path.u.col(column)).barycentric;
    if (barycentric[(k + 2) % 3] <= kOnEdge) normals.col(count++) = outward(mesh_, h);
  }
  return count;
}

void MeshManifold::into_pieces(const CoordinatePath& path, Points& vectors) const {
  for (Index i = 0; i < vectors.cols(); ++i) {
    const Eigen::Vector3d normal = mesh_.face_normal(face_at(mesh_, path, path.free_begin() + i));
    vectors.col(i) -= normal.dot(vectors.col(i)) * normal;
  }
}

std::shared_ptr<const MeshManifold> make_mesh_manifold(const MeshManifoldOptions& options,
                                                       const std::filesystem::path& folder) {
  return std::make_shared<MeshManifold>(
      TriangleMesh(read_mesh(folder / options.file), {options.weld, options.subdivide, options.weld_within}));
}

}  // namespace leastcost
