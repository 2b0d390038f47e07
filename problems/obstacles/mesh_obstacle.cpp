// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/closest_point.hpp>
#include <leastcost/problems/mesh/mesh_report.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "problems/distance/orient_faces.hpp"
#include "problems/distance/winding_number.hpp"
#include "problems/drawing/draws_surface.hpp"
#include "problems/mesh/weld_option.hpp"
#include "problems/obstacles/segment_tree.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

std::vector<SegmentTree::Triangle> triangles_of(const TriangleMesh& mesh) {
  std::vector<SegmentTree::Triangle> all;
  all.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (const auto& [a, b, c] : mesh.faces()) all.push_back({mesh.position(a), mesh.position(b), mesh.position(c)});
  return all;
}

/// Why a mesh has no inside; empty where it has one.
std::string why_hollow(const TriangleMesh& mesh, const FaceOrientation& orientation) {
  const MeshReport report = inspect(mesh);
  if (report.border_edges > 0)
    return "it is open, with " + std::to_string(report.border_edges) +
           " border edges (`weld: true` merges vertices at equal positions, `weld: 1e-6` those no farther apart)";
  if (report.non_manifold_edges > 0)
    return "it has " + std::to_string(report.non_manifold_edges) + " edges with more than two faces";
  if (orientation.one_sided) return "it is one-sided";
  return "";
}

class MeshObstacle final : public Obstacle, public MeetsTriangles, public DrawsSurface {
 public:
  MeshObstacle(const TriangleMesh& mesh, MeshInside inside, double radius, std::string name)
      : name_(std::move(name)), radius_(radius), box_(3), nearest_(mesh), segments_(triangles_of(mesh)) {
    for (const Vector3d& p : mesh.positions()) box_.extend(Vector(p));
    surface_.vertices.assign(mesh.positions().begin(), mesh.positions().end());
    for (const auto& [a, b, c] : mesh.faces()) surface_.triangles.push_back({a, b, c});
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) normals_.push_back(mesh.face_normal(f));
    if (inside == MeshInside::surface) return;
    const FaceOrientation orientation = orient_faces(mesh);
    const std::string why = why_hollow(mesh, orientation);
    if (why.empty())
      winding_.emplace(mesh, orientation.turned);
    else if (inside == MeshInside::solid)
      throw InputError(mesh.source() + ": the mesh has no inside: " + why + "; use it as a surface (inside: surface)");
  }

  std::string name() const override { return name_; }
  Box core_bounds() const override { return box_; }
  double radius() const override { return radius_; }
  Eigen::MatrixXd corners() const override { return {}; }
  TriangleSoup surface() const override { return surface_; }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    const Vector3d place = x;
    const ClosestPoint foot = nearest_.nearest(place);
    const bool within = inside(place);
    away = within ? Vector3d(foot.position - place) : Vector3d(place - foot.position);
    if (foot.distance > 0)
      away /= foot.distance;
    else  // on it: either side is as good, of a solid the one that its faces look to
      away = normal_at(foot.where.face, place);
    return within ? -foot.distance : foot.distance;
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    t = 0;
    if (inside(Vector3d(a))) return 0;
    return segments_.distance(Vector3d(a), Vector3d(b), t);
  }

  double distance_of_triangle(const std::array<Vector3d, 3>& corners, Vector3d& nearest) const override {
    nearest = corners[0];
    if (inside(nearest)) return 0;
    return segments_.distance(corners, nearest);
  }

 private:
  bool inside(const Vector3d& x) const {
    return winding_ && box_.contains(Vector(x)) && std::round(winding_->at(x)) != 0;
  }

  /// Of length one; of a face without a normal, any.
  Vector3d normal_at(std::int32_t face, const Vector3d& x) const {
    const Vector3d normal = normals_[static_cast<std::size_t>(face)];
    if (!(normal.norm() > 0)) return Vector3d::UnitX();
    constexpr double kAside = 1e-6;  // of its size
    const double aside = kAside * (box_.max() - box_.min()).norm();
    return inside(x + aside * normal) && !inside(x - aside * normal) ? Vector3d(-normal) : normal;
  }

  std::string name_;
  double radius_;
  Box box_;
  TriangleSoup surface_;  ///< for drawing
  ClosestPointTree nearest_;
  SegmentTree segments_;
  std::vector<Vector3d> normals_;  ///< of faces
  std::optional<WindingNumber> winding_;
};

Vector3d three(const char* key, const Eigen::VectorXd& given) {
  if (given.size() == 0) return Vector3d::Zero();
  if (given.size() != 3 || !given.allFinite()) throw OptionError(key, "must be three numbers");
  return given;
}

}  // namespace

Words<MeshInside> words(MeshInside) {
  static constexpr std::array<Word<MeshInside>, 3> kWords = {
      {{MeshInside::closed, "auto"}, {MeshInside::solid, "solid"}, {MeshInside::surface, "surface"}}};
  return kWords;
}

void MeshObstacleOptions::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "Mesh file: OBJ, OFF, PLY or STL.", .required = true});
  visit_weld(visit, weld, weld_within);
  visit.choice("inside", inside,
               {.help = "solid: the enclosed volume is part of the obstacle. surface: only the faces are, so a path "
                        "can run inside. auto: solid if the mesh is closed."});
  visit.field("radius", radius, {.help = "Thickness around the mesh.", .unit = "length", .minimum = 0});
  visit.field("scale", scale, {.help = "Scale factor, applied first.", .minimum = 0, .exclusive_minimum = true});
  visit.field("rotation", rotation, {.help = "Rotation vector, axis times angle, applied second.", .unit = "rad"});
  visit.field("translation", translation, {.help = "Translation, applied last.", .unit = "length"});
}

std::shared_ptr<const Obstacle> make_mesh_obstacle(const TriangleMesh& mesh, MeshInside inside, double radius,
                                                   const std::string& name) {
  const std::string by_file = "the mesh " + std::filesystem::path(mesh.source()).filename().string();
  return std::make_shared<MeshObstacle>(mesh, inside, radius, name.empty() ? by_file : name);
}

std::shared_ptr<const Obstacle> make_mesh_obstacle(const MeshObstacleOptions& options,
                                                   const std::filesystem::path& folder, const std::string& name) {
  const Vector3d turn = three("rotation", options.rotation), move = three("translation", options.translation);
  if (!(options.radius >= 0) || !std::isfinite(options.radius))
    throw OptionError("radius", "must be a number, at least 0");
  if (!(options.scale > 0) || !std::isfinite(options.scale))
    throw OptionError("scale", "must be a number greater than 0");
  PolygonSoup soup = read_mesh(folder / options.file);
  const double angle = turn.norm();
  const Eigen::Matrix3d rotation =
      angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity().eval();
  for (Vector3d& p : soup.positions) p = rotation * (options.scale * p) + move;
  return make_mesh_obstacle(TriangleMesh(soup, {options.weld, 0, options.scale * options.weld_within}), options.inside,
                            options.radius, name);
}

}  // namespace leastcost
