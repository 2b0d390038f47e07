// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/grid_obstacle.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/obstacles/raster_obstacles.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include <leastcost/problems/shapes/height_field.hpp>
#include <leastcost/problems/shapes/point_obstacle.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/inputs/map_file.hpp"
#include "catalogue/inputs/planning_scene.hpp"
#include "catalogue/inputs/raster_file.hpp"
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

const std::vector<ObstaclePlugin>& built_in::obstacles() {
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;
  static const std::vector<ObstaclePlugin> own = {
      plugin<ObstaclePlugin, BallOptions>(
          "ball", "A ball; in the plane, a disc.",
          [](const BallOptions& o, const BuildContext&) { return Obstacles{make_ball(o)}; }),
      plugin<ObstaclePlugin, BoxShapeOptions>(
          "box", "A box, turned or along the axes; in the plane a rectangle; requires a clearance.",
          [](const BoxShapeOptions& o, const BuildContext&) { return Obstacles{make_box(o)}; }),
      plugin<ObstaclePlugin, CapsuleObstacleOptions>(
          "capsule", "All points within a radius of a segment.",
          [](const CapsuleObstacleOptions& o, const BuildContext&) { return Obstacles{make_capsule(o)}; }),
      plugin<ObstaclePlugin, CylinderOptions>(
          "cylinder", "A cylinder with flat ends in space; requires a clearance.",
          [](const CylinderOptions& o, const BuildContext&) { return Obstacles{make_cylinder(o)}; }),
      plugin<ObstaclePlugin, ConeOptions>(
          "cone", "A cone or a frustum of one in space; requires a clearance.",
          [](const ConeOptions& o, const BuildContext&) { return Obstacles{make_cone(o)}; }),
      plugin<ObstaclePlugin, HalfSpaceOptions>(
          "half_space", "All points behind a plane, such as the ground; requires a clearance.",
          [](const HalfSpaceOptions& o, const BuildContext&) { return Obstacles{make_half_space(o)}; }),
      plugin<ObstaclePlugin, PolygonOptions>(
          "polygon", "A polygon in the plane, convex or not; requires a clearance.",
          [](const PolygonOptions& o, const BuildContext&) { return Obstacles{make_polygon(o)}; }),
      plugin<ObstaclePlugin, OccupancyOptions>(
          "map", "The blocked cells of an occupancy map, as boxes in the plane; requires a clearance.",
          [](const OccupancyOptions& o, const BuildContext& c) { return map_obstacles(read_map(o, c.folder)); })
          .waiting(),
      plugin<ObstaclePlugin, RasterObstacleOptions>(
          "raster", "Cells of a raster without data, or above or below a value, as boxes; requires a clearance.",
          [](const RasterObstacleOptions& o, const BuildContext& c) {
            return make_raster_obstacles(read_raster(o.raster, c.folder, Resampling::nearest, c.note), o);
          })
          .waiting()
          .checked_by<RasterObstacleOptions>(
              [](const RasterObstacleOptions& o, const BuildContext&) { check(o.raster); }),
      plugin<ObstaclePlugin, MeshObstacleOptions>(
          "mesh", "A triangle mesh in space, solid or as a surface; requires a clearance or a thickness.",
          [](const MeshObstacleOptions& o, const BuildContext& c) {
            return Obstacles{make_mesh_obstacle(o, c.folder)};
          })
          .waiting(),
      plugin<ObstaclePlugin, HeightFieldOptions>(
          "height_field", "Ground in space: all that is below the heights of a raster; requires a clearance.",
          [](const HeightFieldOptions& o, const BuildContext& c) {
            check(o);
            const RasterGrid heights = o.raster.file.empty()
                                           ? raster_of_heights(o)
                                           : read_raster(o.raster, c.folder, Resampling::bilinear, c.note);
            return Obstacles{make_height_field(heights, o)};
          })
          .waiting()
          .checked_by<HeightFieldOptions>([](const HeightFieldOptions& o, const BuildContext&) { check(o); }),
      plugin<ObstaclePlugin, PointObstacleOptions>("points",
                                                   "A point cloud in space: all places within a radius of a point.",
                                                   [](const PointObstacleOptions& o, const BuildContext& c) {
                                                     return Obstacles{make_point_obstacle(o, c.folder)};
                                                   })
          .waiting(),
      plugin<ObstaclePlugin, PlanningSceneOptions>(
          "scene", "The objects of a planning scene in space, from a file; requires a clearance.",
          [](const PlanningSceneOptions& o, const BuildContext& c) { return read_planning_scene(o, c.folder, c.note); })
          .waiting(),
      plugin<ObstaclePlugin, GridObstacleOptions>(
          "distance_grid", "A signed distance on a regular grid in space; requires a clearance or a thickness.",
          [](const GridObstacleOptions& o, const BuildContext& c) {
            return Obstacles{make_grid_obstacle(o, c.folder)};
          })
          .waiting(),
  };
  static const std::vector<ObstaclePlugin> all = built_in::with_those_of_libraries(own, obstacles_of_libraries());
  return all;
}

}  // namespace leastcost
