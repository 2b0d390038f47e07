// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/metric_mesh.hpp"

#include <Eigen/LU>
#include <cassert>
#include <utility>

namespace leastcost {
namespace {

PolygonSoup turned(const TriangleMesh& mesh, const Eigen::Matrix3d& root, const Eigen::Vector3d& centre) {
  PolygonSoup soup;
  soup.source = mesh.source();
  soup.positions.reserve(mesh.positions().size());
  for (const Eigen::Vector3d& p : mesh.positions()) soup.positions.emplace_back(root * (p - centre));
  soup.corners.reserve(3 * mesh.faces().size());
  soup.polygon_begin.reserve(mesh.faces().size() + 1);
  soup.polygon_begin.assign(1, 0);
  for (const auto& face : mesh.faces()) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.polygon_begin.push_back(static_cast<std::int32_t>(soup.corners.size()));
  }
  return soup;
}

}  // namespace

MetricMesh::MetricMesh(const TriangleMesh& mesh, const Eigen::Matrix3d& root, const Eigen::Vector3d& centre)
    : root_(root), inverse_(root.inverse()), centre_(centre), mesh_(turned(mesh, root, centre_)) {
  // All corners differ and all vertices are used, so that nothing was left out.
  assert(mesh_.vertex_count() == mesh.vertex_count() && mesh_.face_count() == mesh.face_count());
}

SurfacePath MetricMesh::there(SurfacePath path) const {
  for (Eigen::Vector3d& p : path.points) p = Eigen::Vector3d(root_ * (p - centre_));
  return path;
}

SurfacePath MetricMesh::back(SurfacePath path) const {
  for (Eigen::Vector3d& p : path.points) p = Eigen::Vector3d(inverse_ * p + centre_);
  return path;
}

}  // namespace leastcost
