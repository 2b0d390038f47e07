// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/section/plane_section.hpp"

#include <algorithm>
#include <utility>

#include "problems/mesh/surface_walk.hpp"

namespace leastcost {
namespace {

/// Follows curves through faces, each face once: the plane crosses a face in one piece.
class CurveFollower {
 public:
  CurveFollower(const TriangleMesh& mesh, const PlaneSection& section)
      : mesh_(&mesh), section_(&section), done_(static_cast<std::size_t>(mesh.face_count()), 0) {}

  bool done(std::int32_t face) const { return done_[static_cast<std::size_t>(face)] != 0; }

  /// Out of the face of halfedge h through h, until back in that face (0) or at an edge without a face behind it (its
  /// code). `path` gets the points crossed.
  std::int32_t follow(std::int32_t h, SurfacePath& path) {
    const std::int32_t first = h / 3;
    path.points.assign(1, section_->crossing(h));
    path.faces.clear();
    mark(first);
    for (;;) {
      const std::int32_t entry = mesh_->across(h);
      if (entry < 0) return entry;
      h = section_->exit(entry);
      append_point(path, section_->crossing(h), h / 3);
      if (h / 3 == first) return 0;
      mark(h / 3);
    }
  }

 private:
  void mark(std::int32_t face) { done_[static_cast<std::size_t>(face)] = 1; }

  const TriangleMesh* mesh_;
  const PlaneSection* section_;
  std::vector<char> done_;
};

}  // namespace

Eigen::Vector3d PlaneSection::crossing(std::int32_t h) const {
  const Eigen::Vector3d& p = mesh_->position(mesh_->tail(h));
  const Eigen::Vector3d& q = mesh_->position(mesh_->head(h));
  const double a = height(mesh_->tail(h)), b = height(mesh_->head(h));
  const double t = a / (a - b);
  return t < 0.5 ? Eigen::Vector3d(p + t * (q - p)) : Eigen::Vector3d(q + (1 - t) * (p - q));
}

SectionCurves section_curves(const TriangleMesh& mesh, const Eigen::Vector3d& through, const Eigen::Vector3d& normal,
                             const Deadline& deadline) {
  constexpr std::int32_t kLook = 4096;  // faces between two looks at the clock
  const PlaneSection section(mesh, through, normal);
  CurveFollower follower(mesh, section);
  SectionCurves curves;
  SurfacePath path;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    if (f % kLook == 0) look_at_clock(deadline);
    std::int32_t h = 3 * f;
    while (h < 3 * f + 3 && !section.crosses(h)) ++h;
    if (h == 3 * f + 3 || follower.done(f)) continue;
    const std::int32_t end = follower.follow(h, path);
    if (end == 0) {
      path.points.back() = path.points.front();  // computed from the two sides of one edge
      if (path.faces.size() > 1) curves.closed.push_back(std::move(path));
      continue;
    }
    const std::int32_t other_end = follower.follow(section.exit(h), path);  // the other half of an open curve
    const bool at_edge = end == TriangleMesh::kNonManifold || other_end == TriangleMesh::kNonManifold;
    ++(at_edge ? curves.at_edge : curves.at_border);
  }
  return curves;
}

}  // namespace leastcost
