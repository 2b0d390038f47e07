// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include <leastcost/problems/manifolds/earth.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/manifolds/pose.hpp>
#include "catalogue/inputs/map_file.hpp"
#include "catalogue/inputs/raster_file.hpp"
#include "catalogue/plugins/registration.hpp"
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

/// A joint without limits has none in the box.
std::shared_ptr<const EuclideanManifold> joint_box(const std::shared_ptr<const Robot>& robot) {
  if (robot == nullptr)
    throw OptionError("type", "'robot' is the box of joint limits of a robot, but there is none: give 'robot'");
  const Kinematics& kinematics = *robot->kinematics;
  if (kinematics.link_count() == 1)
    throw OptionError("type",
                      "'robot' is the box of joint limits of an arm, but a rigid body has no joints: give its "
                      "positions, as {type: euclidean, dimension: 3} in the plane");
  EuclideanManifoldOptions options{.dimension = static_cast<int>(kinematics.dimension())};
  options.box = {kinematics.lower(), kinematics.upper()};
  return std::make_shared<const EuclideanManifold>(options);
}

void say(const BuildContext& context, const std::string& note) {
  if (context.note && !note.empty()) context.note(note);
}

/// A path on a surface that crosses itself does not change from one sheet to the other where they meet.
void note_crossing(const ParametricOptions& options, const BuildContext& context) {
  const auto* torus = std::get_if<parametric::Torus>(&options.surface);
  if (torus == nullptr || torus->minor_radius <= torus->major_radius) return;
  say(context, "the torus crosses itself, because minor_radius (" + short_number(torus->minor_radius, 6) +
                   ") is larger than major_radius (" + short_number(torus->major_radius, 6) +
                   "): paths do not change between its sheets where they cross");
}

}  // namespace

const std::vector<ManifoldPlugin>& built_in::manifolds() {
  static const std::vector<ManifoldPlugin> all = {
      made_of<ManifoldPlugin, EuclideanManifold, EuclideanManifoldOptions>("euclidean", "R^d, or a box in it."),
      plugin<ManifoldPlugin, NoOptions>("robot", "The configurations of the robot: the box of its joint limits.",
                                        [](const NoOptions&, const BuildContext& c) { return joint_box(c.robot); })
          .waiting<NoOptions>([](const NoOptions&) { return WaitsFor::robot; })
          .of_dimension(0),
      plugin<ManifoldPlugin, MeshManifoldOptions>(
          "mesh", "A triangle mesh in R^3, read from an OBJ, OFF, PLY or STL file.",
          [](const MeshManifoldOptions& o, const BuildContext& c) { return make_mesh_manifold(o, c.folder); })
          .waiting(),
      plugin<ManifoldPlugin, OccupancyOptions>(
          "map", "The free part of the plane on an occupancy map: Moving AI, PNG, PGM or map_server YAML.",
          [](const OccupancyOptions& o, const BuildContext& c) {
            return std::make_shared<const MapManifold>(read_map(o, c.folder));
          })
          .waiting()
          .of_dimension(2),
      plugin<ManifoldPlugin, ParametricOptions>(
          "parametric", "A surface x(u, v) in R^3, by name or by formulas; points are given in u and v.",
          [](const ParametricOptions& o, const BuildContext& c) {
            note_crossing(o, c);
            return make_parametric_manifold(o);
          }),
      made_of<ManifoldPlugin, EarthManifold, EarthOptions>(
          "earth", "The WGS84 ellipsoid; points are (latitude, longitude) in degrees, lengths in metres."),
      plugin<ManifoldPlugin, ImplicitManifoldOptions>(
          "implicit", "A surface f(x, y, z) = 0, or a curve f(x, y) = 0: by name or as a formula.",
          [](const ImplicitManifoldOptions& o, const BuildContext&) { return make_implicit_manifold(o); }),
      plugin<ManifoldPlugin, ConstraintManifoldOptions>(
          "constraint", "The solutions of equations in R^n: formulas, the n-sphere, the rotations SO(3).",
          [](const ConstraintManifoldOptions& o, const BuildContext&) { return make_constraint_manifold(o); }),
      plugin<ManifoldPlugin, PoseOptions>(
          "se2", "Poses of a body in the plane: points (x, y, angle), the angle in radians.",
          [](const PoseOptions& o, const BuildContext&) { return make_planar_poses(o); }),
      plugin<ManifoldPlugin, PoseOptions>(
          "se3", "Poses of a body in space: points (x, y, z, qw, qx, qy, qz) with a unit quaternion.",
          [](const PoseOptions& o, const BuildContext&) { return make_spatial_poses(o); }),
      plugin<ManifoldPlugin, PointCloudManifoldOptions>(
          "point_cloud", "The smooth surface through a point cloud in R^3, read from a PLY or XYZ file.",
          [](const PointCloudManifoldOptions& o, const BuildContext& c) {
            return make_point_cloud_manifold(o, c.folder);
          })
          .waiting(),
      plugin<ManifoldPlugin, SignedDistanceOptions>(
          "signed_distance",
          "The zero set of a signed-distance grid, computed from a mesh, a cloud or a formula, or read from a file.",
          [](const SignedDistanceOptions& o, const BuildContext& c) {
            return make_signed_distance_manifold(o, c.folder, c.progress);
          })
          .waiting()
          .checked_by<SignedDistanceOptions>(
              [](const SignedDistanceOptions& o, const BuildContext&) { check_signed_distance(o); }),
      plugin<ManifoldPlugin, RasterOptions>(
          "terrain", "The surface (x, y, z(x, y)) over a raster of heights; points are map coordinates (x, y).",
          [](const RasterOptions& o, const BuildContext& c) {
            RasterGrid heights = read_raster(o, c.folder, Resampling::bilinear, c.note);
            check_heights(heights, o);
            say(c, check_slopes(heights, o));
            return std::make_shared<const TerrainManifold>(std::move(heights));
          })
          .waiting()
          .checked_by<RasterOptions>([](const RasterOptions& o, const BuildContext&) { check(o); }),
  };
  return all;
}

}  // namespace leastcost
