// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/face_obstacle.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/drawing/draws_surface.hpp"
#include "problems/obstacles/segment_tree.hpp"
#include "problems/obstacles/triangle_foot.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using FaceCorners = std::array<Vector3d, 3>;

class FaceObstacle final : public Obstacle, public MeetsTriangles, public DrawsSurface {
 public:
  FaceObstacle(std::string name, const FaceCorners& corners, const Vector3d& normal, double radius)
      : name_(std::move(name)), corners_(corners), normal_(normal), radius_(radius), tree_({corners}) {}

  std::string name() const override { return name_; }
  Box core_bounds() const override {
    Box box(3);
    for (const Vector3d& corner : corners_) box.extend(Vector(corner));
    return box;
  }
  double radius() const override { return radius_; }
  bool convex() const override { return true; }
  Eigen::MatrixXd corners() const override { return {}; }  // asked for in the plane
  TriangleSoup surface() const override { return {{corners_.begin(), corners_.end()}, {{0, 1, 2}}}; }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    away = x - foot_on_triangle(corners_, Vector3d(x));
    const double distance = away.norm();
    if (distance > 0)
      away /= distance;
    else
      away = normal_;  // on it: either side is as good
    return distance;
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    return tree_.distance(Vector3d(a), Vector3d(b), t);
  }

  double distance_of_triangle(const FaceCorners& corners, Vector3d& nearest) const override {
    return tree_.distance(corners, nearest);
  }

 private:
  std::string name_;
  FaceCorners corners_;
  Vector3d normal_;
  double radius_;
  SegmentTree tree_;
};

}  // namespace

std::vector<std::shared_ptr<const Obstacle>> make_face_obstacles(const TriangleMesh& mesh, double radius) {
  const std::string file = std::filesystem::path(mesh.source()).filename().string();
  std::vector<std::shared_ptr<const Obstacle>> all;
  std::set<std::array<std::int32_t, 3>> known;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    auto vertices = mesh.faces()[static_cast<std::size_t>(f)];
    const FaceCorners corners = {mesh.position(vertices[0]), mesh.position(vertices[1]), mesh.position(vertices[2])};
    const Vector3d normal = mesh.face_normal(f);
    std::sort(vertices.begin(), vertices.end());
    if (!(normal.norm() > 0) || !known.insert({vertices[0], vertices[1], vertices[2]}).second) continue;
    all.push_back(std::make_shared<FaceObstacle>("face " + std::to_string(f) + " of " + file, corners, normal, radius));
  }
  if (all.empty()) throw InputError(mesh.source() + ": none of its faces has an area");
  return all;
}

}  // namespace leastcost
