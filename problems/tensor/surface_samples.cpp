// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/tensor/surface_samples.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace leastcost {
namespace {

// Small, because a mean over a support is off by its square; large enough for a dozen samples.
constexpr double kVertexSupport = 1.6;  ///< spacings
constexpr double kFaceSupport = 2;      ///< radii of the face
constexpr double kCloudSupport = 0.5;   ///< supports of the surface fit, that is 2 spacings on a clean cloud

/// A face of the file, put together from the triangles it became.
struct FileFace {
  double area = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double radius = 0;  ///< from the centre to the farthest corner
};

std::vector<FileFace> file_faces(const TriangleMesh& mesh) {
  std::vector<FileFace> faces(static_cast<std::size_t>(mesh.file_face_count()));
  const auto of = [&](std::int32_t f) -> FileFace& { return faces[static_cast<std::size_t>(mesh.file_face(f))]; };
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.face(f);
    const Eigen::Vector3d &p = mesh.position(a), &q = mesh.position(b), &r = mesh.position(c);
    // Longest side times a little: a face without area has a centre as well.
    const double longest = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
    const double area = (q - p).cross(r - p).norm() / 2 + 1e-12 * longest * longest;
    of(f).area += area;
    of(f).centre += area / 3 * (p + q + r);
    of(f).normal += area * mesh.face_normal(f);
  }
  for (FileFace& face : faces) {
    if (!(face.area > 0)) continue;
    face.centre /= face.area;
    face.normal.stableNormalize();
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f)
    for (const std::int32_t v : mesh.face(f))
      of(f).radius = std::max(of(f).radius, (mesh.position(v) - of(f).centre).norm());
  return faces;
}

Eigen::Vector3d vertex_normal(const TriangleMesh& mesh, std::int32_t v) {
  const std::int32_t f = mesh.faces_of_vertex(v).front();
  SurfacePoint corner{f, Eigen::Vector3d::Zero()};
  for (int k = 0; k < 3; ++k)
    if (mesh.face(f)[static_cast<std::size_t>(k)] == v) corner.barycentric[k] = 1;
  return mesh.smooth_normal(corner);
}

}  // namespace

SurfaceSamples vertex_samples(const TriangleMesh& mesh) {
  const std::vector<FileFace> faces = file_faces(mesh);
  SurfaceSamples out;
  out.what = "vertices";
  out.oriented = mesh.flipped_halfedges().empty();
  out.count_in_file = mesh.file_vertex_count();
  for (std::int32_t number = 0; number < out.count_in_file; ++number) {
    const std::int32_t v = mesh.vertex_of_file(number);
    if (v < 0) continue;
    double reach = 0;  // to the far corners of the faces around
    for (const std::int32_t f : mesh.faces_of_vertex(v)) {
      const FileFace& face = faces[static_cast<std::size_t>(mesh.file_face(f))];
      reach = std::max(reach, (mesh.position(v) - face.centre).norm() + face.radius);
    }
    out.positions.push_back(mesh.position(v));
    out.normals.push_back(vertex_normal(mesh, v));
    out.spacing.push_back(reach * std::sqrt(3) / 2);  // the side of an equilateral triangle
    out.support.push_back(kVertexSupport * out.spacing.back());
    out.in_file.push_back(number);
  }
  return out;
}

SurfaceSamples face_samples(const TriangleMesh& mesh) {
  SurfaceSamples out;
  out.what = "faces";
  out.oriented = mesh.flipped_halfedges().empty();
  out.count_in_file = mesh.file_face_count();
  std::int32_t number = 0;
  for (const FileFace& face : file_faces(mesh)) {
    if (face.radius > 0) {
      out.positions.push_back(face.centre);
      out.normals.push_back(face.normal);
      out.spacing.push_back(std::sqrt(face.area));
      out.support.push_back(kFaceSupport * face.radius);
      out.in_file.push_back(number);
    }
    ++number;
  }
  return out;
}

SurfaceSamples point_samples(const PointCloud& cloud) {
  SurfaceSamples out;
  out.what = "points";
  out.oriented = true;
  out.count_in_file = cloud.count_in_file();
  for (std::int32_t i = 0; i < cloud.size(); ++i) {
    out.positions.emplace_back(cloud.sample(i).position + cloud.centre());
    out.normals.push_back(cloud.sample(i).normal);
    out.spacing.push_back(cloud.spacing(i));
    out.support.push_back(kCloudSupport * cloud.radius(i));
    out.in_file.push_back(cloud.in_file(i));
  }
  return out;
}

}  // namespace leastcost
