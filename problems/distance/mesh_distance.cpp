// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/mesh_distance.hpp"

#include <cmath>
#include <optional>
#include <sstream>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/closest_point.hpp>
#include <leastcost/problems/mesh/mesh_report.hpp>
#include "framework/base/point_text.hpp"
#include "problems/distance/distance_signs.hpp"
#include "problems/distance/foot_points.hpp"
#include "problems/distance/orient_faces.hpp"
#include "problems/distance/winding_number.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kWhole = 0.25;      ///< most that a winding number may be off an integer
constexpr double kOnSurface = 1e-6;  ///< cells from the surface within which the sign of a node says nothing

/// A point on some border edge.
Vector3d on_border(const TriangleMesh& mesh) {
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h)
    if (mesh.across(h) == TriangleMesh::kBorder) return (mesh.position(mesh.tail(h)) + mesh.position(mesh.head(h))) / 2;
  return mesh.position(0);
}

constexpr const char* kUnsigned = "; close it, or use the surface at a distance from it (sign: unsigned, offset)";

/// Throws where there is no inside; else the orientation.
FaceOrientation oriented(const TriangleMesh& mesh) {
  const MeshReport report = inspect(mesh);
  if (report.border_edges > 0)
    throw InputError(mesh.source() + ": the mesh is open, so it has no inside: " + std::to_string(report.border_edges) +
                     " border edges in " + std::to_string(report.boundary_loops) + " loops, one at " +
                     point_text(on_border(mesh)) +
                     ". `weld: true` merges vertices at equal positions, `weld: 1e-6` those no farther apart, in "
                     "length units. Close holes, or use the surface at a distance from it (sign: unsigned, offset)");
  FaceOrientation orientation = orient_faces(mesh);
  if (orientation.one_sided)
    throw InputError(mesh.source() + ": the surface is one-sided, so it has no inside (seen at face " +
                     std::to_string(mesh.file_face(*orientation.one_sided)) + ")" + kUnsigned);
  return orientation;
}

class MeshDistance final : public DistanceSource {
 public:
  MeshDistance(const TriangleMesh& mesh, bool sides)
      : source_(mesh.source()), tree_(mesh), vertices_(mesh.positions()) {
    for (const Vector3d& p : mesh.positions()) box_.extend(p);
    if (!sides) return;
    const FaceOrientation orientation = oriented(mesh);
    if (orientation.turned_count > 0)
      notes_.push_back(std::to_string(orientation.turned_count) + " faces turned to agree with their neighbours");
    winding_.emplace(mesh, orientation.turned);
  }

  Eigen::AlignedBox3d box() const override { return box_; }
  std::vector<std::string> notes() const override { return notes_; }
  std::optional<Vector3d> foot(const Vector3d& x) const override { return tree_.nearest(x).position; }

  std::vector<double> sample(const GridShape& shape, double exact, const BuildProgress& progress) const override {
    FootPointGrid field(shape);
    const auto nearest = [this](const Vector3d& x, std::int32_t hint) -> std::optional<Foot> {
      const ClosestPoint point = tree_.nearest(x, hint);
      return Foot{point.position, point.where.face};
    };
    fill_band(field, vertices_, exact, nearest, progress);
    spread_feet(field, progress);
    std::vector<double> values = std::move(field.distance);
    if (!winding_) return values;
    report(progress, 0, "inside and outside");
    sign_by_parts(shape, values, [&](const Vector3d& x, double distance) {
      const double w = winding_->at(x);
      if (std::abs(w - std::round(w)) > kWhole && distance > kOnSurface * shape.cell) throw InputError(not_whole(x, w));
      return std::round(w) != 0;
    });
    return values;
  }

 private:
  std::string not_whole(const Vector3d& x, double w) const {
    std::ostringstream out;
    out.precision(3);
    out << source_ << ": the mesh has no clear inside: its winding number at " << point_text(x) << " is " << w
        << ", which is not an integer (edges with an odd number of faces?)" << kUnsigned;
    return out.str();
  }

  std::string source_;
  ClosestPointTree tree_;
  std::vector<Vector3d> vertices_;
  Eigen::AlignedBox3d box_;
  std::optional<WindingNumber> winding_;
  std::vector<std::string> notes_;
};

}  // namespace

std::shared_ptr<const DistanceSource> make_mesh_distance(const TriangleMesh& mesh, bool sides) {
  return std::make_shared<MeshDistance>(mesh, sides);
}

}  // namespace leastcost
