// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/registry.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

#include <leastcost/problems/costs/clearance_length.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/end_effector_length.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/formula_cost.hpp>
#include <leastcost/problems/costs/kinetic_energy.hpp>
#include <leastcost/problems/costs/layers.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/cell_graph.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
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
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/grid_obstacle.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/obstacles/raster_obstacles.hpp>
#include <leastcost/problems/post_processors/on_surface.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/switchbacks.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include <leastcost/problems/shapes/height_field.hpp>
#include <leastcost/problems/shapes/point_obstacle.hpp>
#include <leastcost/solvers/georce.hpp>
#include <leastcost/solvers/gradient_descent.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include <leastcost/solvers/string_method.hpp>
#include <leastcost/solvers/vfcs.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/inputs/map_file.hpp"
#include "catalogue/inputs/planning_scene.hpp"
#include "catalogue/inputs/raster_file.hpp"
#include "catalogue/plugins/attached_options.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/plugins/registration.hpp"
#include "catalogue/registry/combined_costs.hpp"
#include "problems/readers/waypoint_reader.hpp"

namespace leastcost {
namespace {

template <class Function>
KernelPlugin kernel(const char* type, const char* summary) {
  return plugin<KernelPlugin, NoOptions>(type, summary,
                                         [](const NoOptions&, const BuildContext&) { return make_kernel(Function{}); });
}

const auto& kernels() {
  static const std::vector<KernelPlugin> all = {
      kernel<Linear>("linear",
                     "H(s) = s: the plain cost. Points can slide along the path, so nothing can be certified."),
      kernel<Square>("square", "H(s) = s^2: the usual path energy; enforces equal spacing less strongly."),
      kernel<Expm1Square>("expm1_square",
                          "H(s) = exp(s^2) - 1: the choice of VFCS, enforces equal spacing most strongly."),
      kernel<Exp>("exp", "H(s) = exp(s)."),
      kernel<Expm1>("expm1", "H(s) = exp(s) - 1."),
      kernel<ExpSquare>("exp_square", "H(s) = exp(s^2)."),
  };
  return all;
}

void check_map(const CostMapOptions& options, const BuildContext& context) {
  check(options.raster);
  const std::string why = why_no_map_of(context.manifold.get());
  if (!why.empty()) throw OptionError("type", why);
}

const auto& costs() {
  using O = const BuildContext&;
  static const std::vector<CostPlugin> all = {
      plugin<CostPlugin, NoOptions>("euclidean", "Length: c(a, b) = |b - a|.",
                                    [](const NoOptions&, O c) { return make_euclidean_cost(c.dimension); }),
      plugin<CostPlugin, MetricTensorOptions>(
          "metric_tensor", "Length under a constant metric tensor M: c(a, b) = sqrt((b - a)' M (b - a)).",
          [](const MetricTensorOptions& o, O c) { return make_metric_tensor_cost(o, c.dimension); }),
      plugin<CostPlugin, MetricFieldOptions>("metric_field",
                                             "Length under a metric tensor that varies with position: by name, by "
                                             "formulas, from a file, or from curvature.",
                                             [](const MetricFieldOptions& o, O c) {
                                               return make_metric_field_cost(o, c.dimension, c.manifold.get(),
                                                                             c.folder);
                                             })
          .waiting<MetricFieldOptions>(
              [](const MetricFieldOptions& o) { return o.needs_domain() ? WaitsFor::domain : WaitsFor::nothing; }),
      plugin<CostPlugin, TravelTimeOptions>(
          "travel_time", "Time of a bead that slides without friction, under gravity or in a potential.",
          [](const TravelTimeOptions& o, O c) { return make_travel_time_cost(o, c.dimension, c.source); })
          .waiting<TravelTimeOptions>([](const TravelTimeOptions&) { return WaitsFor::domain; })
          .checked_by<TravelTimeOptions>(
              [](const TravelTimeOptions& o, O c) { check_travel_time(o, c.source.has_value()); })
          .following_source(),
      plugin<CostPlugin, ClearanceLengthOptions>(
          "clearance", "Length with a weight that increases smoothly near obstacles.",
          [](const ClearanceLengthOptions& o, O c) { return make_clearance_length(o, c.dimension, c.manifold); })
          .waiting<ClearanceLengthOptions>([](const ClearanceLengthOptions&) { return WaitsFor::domain; }),
      plugin<CostPlugin, CostMapOptions>(
          "cost_map", "Length times a cost per unit of length in the plane, from a raster.",
          [](const CostMapOptions& o, O c) {
            check_map(o, c);
            return make_cost_map(read_raster(o.raster, c.folder, Resampling::nearest, c.note), o.interpolation,
                                 c.dimension);
          })
          .waiting()
          .checked_by<CostMapOptions>(check_map),
      plugin<CostPlugin, WeightedLengthOptions>(
          "weighted_length", "Length with a weight for each factor of the domain, or for each coordinate.",
          [](const WeightedLengthOptions& o, O c) { return make_weighted_length(o, *c.manifold); })
          .waiting<WeightedLengthOptions>([](const WeightedLengthOptions&) { return WaitsFor::domain; }),
      plugin<CostPlugin, LayersOptions>(
          "layers", "Length or time through layers of constant index, with refraction at the interfaces.",
          [](const LayersOptions& o, O c) { return make_layers_cost(o, c.dimension); }),
      plugin<CostPlugin, KineticEnergyOptions>(
          "kinetic_energy",
          "Length under the kinetic energy of an arm; least-cost paths are its motions without forces.",
          [](const KineticEnergyOptions& o, O c) { return make_kinetic_energy_cost(o, c.dimension); }),
      plugin<CostPlugin, EndEffectorLengthOptions>(
          "end_effector_length", "Length of the path of an arm's tool, plus a small part of that of its joints.",
          [](const EndEffectorLengthOptions& o, O c) { return make_end_effector_length(o, c.dimension); }),
      plugin<CostPlugin, ZermeloOptions>(
          "zermelo", "Travel time of a vehicle of given speed in wind or current, by formula or on a grid.",
          [](const ZermeloOptions& o, O c) { return make_zermelo_cost(o, c.dimension, c.folder); })
          .waiting<ZermeloOptions>(
              [](const ZermeloOptions& o) { return o.reads_file() ? WaitsFor::files : WaitsFor::nothing; })
          .checked_by<ZermeloOptions>([](const ZermeloOptions& o, O c) { check_zermelo(o, c.dimension); }),
      plugin<CostPlugin, WalkingOptions>(
          "walking",
          "Time or energy of walking over terrain, with switchbacks on steep slopes; the last of three coordinates is "
          "height.",
          [](const WalkingOptions& o, O c) { return make_walking_cost(o, c.dimension); }),
      plugin<CostPlugin, RefractiveIndexOptions>(
          "refractive_index", "Optical length under an index n(x): linear velocity, lenses, layers, powers, formulas.",
          [](const RefractiveIndexOptions& o, O c) { return make_refractive_index_cost(o, c.dimension); }),
      plugin<CostPlugin, FormulaCostOptions>(
          "formula",
          "Any cost per unit of length F(x, v), as a formula in position and direction; asymmetric costs are allowed.",
          [](const FormulaCostOptions& o, O c) {
            return make_formula_cost(o, c.dimension, checked_region(*c.manifold, c.source, c.target));
          })
          .waiting<FormulaCostOptions>([](const FormulaCostOptions&) { return WaitsFor::domain; }),
      plugin<CostPlugin, SumCostOptions>("sum", "A sum of costs with positive weights.",
                                         [](const SumCostOptions& o, O c) { return make_sum(o, c); })
          .waiting<SumCostOptions>([](const SumCostOptions& o) { return waits_of(o); })
          .checked_by<SumCostOptions>([](const SumCostOptions& o, O c) { check_parts_of(o, c); })
          .following_source(),
      plugin<CostPlugin, ScaledCostOptions>("scaled", "A cost times a positive field f(x), given as a formula.",
                                            [](const ScaledCostOptions& o, O c) { return make_scaled(o, c); })
          .waiting<ScaledCostOptions>([](const ScaledCostOptions& o) { return waits_of(o); })
          .checked_by<ScaledCostOptions>([](const ScaledCostOptions& o, O c) { check_parts_of(o, c); })
          .following_source(),
  };
  return all;
}

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

const auto& manifolds() {
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
          [](const ParametricOptions& o, const BuildContext&) { return make_parametric_manifold(o); }),
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
            check_slopes(heights, o);
            check_heights(heights, o);
            return std::make_shared<const TerrainManifold>(std::move(heights));
          })
          .waiting()
          .checked_by<RasterOptions>([](const RasterOptions& o, const BuildContext&) { check(o); }),
  };
  return all;
}

template <class P>
std::vector<P> with_those_of_libraries(std::vector<P> own, std::vector<P> others) {
  std::move(others.begin(), others.end(), std::back_inserter(own));
  return own;
}

const auto& obstacles() {
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
  static const std::vector<ObstaclePlugin> all = with_those_of_libraries(own, obstacles_of_libraries());
  return all;
}

const auto& robots() {
  static const std::vector<RobotPlugin> all = with_those_of_libraries<RobotPlugin>(
      {
          plugin<RobotPlugin, WithAttached<DhArmOptions>>(
              "dh_arm",
              "An arm with revolute joints, from a Denavit-Hartenberg table; a configuration is its joint angles.",
              [](const WithAttached<DhArmOptions>& o, const BuildContext& c) {
                return attach(make_dh_arm(o.robot), o.attached, c.folder);
              })
              .waiting<WithAttached<DhArmOptions>>([](const WithAttached<DhArmOptions>& o) {
                return has_files(o.attached) ? WaitsFor::files : WaitsFor::nothing;
              }),
          plugin<RobotPlugin, RigidBodyOptions>(
              "rigid_body",
              "A body of balls and capsules, in the plane (x, y, angle) or in space (x, y, z, quaternion).",
              [](const RigidBodyOptions& o, const BuildContext&) { return make_rigid_body(o); }),
      },
      robots_of_libraries());
  return all;
}

const auto& initializers() {
  static const std::vector<InitializerPlugin> own = {
      made_of<InitializerPlugin, StraightInitializer>(
          "straight", "The straight line between the ends, bent around places where its cost is infinite."),
      made_of<InitializerPlugin, BowInitializer, BowOptions>("bow", "An arc on a given side of the straight line."),
      made_of<InitializerPlugin, DijkstraInitializer, DijkstraOptions>(
          "dijkstra", "The least-cost path along the edges of the mesh, or the neighbour graph of the cloud.")
          .needing<HasGraph>(),
      made_of<InitializerPlugin, PlaneCutInitializer, PlaneCutOptions>(
          "plane_cut", "The closed curve in which a plane cuts the surface, for a ring.")
          .needing<IsSurface>(),
      made_of<InitializerPlugin, EikonalInitializer, EikonalOptions>(
          "eikonal", "Follows the arrival-cost field back to the source, over two coordinates, for any cost."),
      made_of<InitializerPlugin, CellGraphInitializer, CellGraphOptions>(
          "cell_graph", "The least-cost path between points on the cell sides of a cost map (interpolation: cells)."),
      made_of<InitializerPlugin, GridInitializer, GridOptions>(
          "grid", "A least-cost route over a regular grid in the plane or in space that keeps clear of obstacles."),
      plugin<InitializerPlugin, RrtOptions>(
          "rrt", "Random trees from both ends, for robots, among obstacles and near smooth domains; shortened.",
          [](const RrtOptions& o, const BuildContext& c) { return std::make_shared<const RrtInitializer>(o, c.seed); }),
      plugin<InitializerPlugin, WaypointsOptions>("waypoints", "A path through the given points, in order.",
                                                  [](const WaypointsOptions& o, const BuildContext&) {
                                                    return std::make_shared<const WaypointsInitializer>(
                                                        o.points.transpose());
                                                  }),
      made_of<InitializerPlugin, CoordinateCircleInitializer, CoordinateCircleOptions>(
          "coordinate_circle", "A ring along which one coordinate of a chart runs once or more through its period.")
          .needing<HasSeams>(),
      plugin<InitializerPlugin, FileInitializerOptions>(
          "file", "A path through the points of a text file, such as the path.csv of an earlier run.",
          [](const FileInitializerOptions& o, const BuildContext& c) {
            return std::make_shared<const WaypointsInitializer>(read_waypoints(c.folder / o.file, c.coordinates));
          })
          .waiting(),
  };
  static const std::vector<InitializerPlugin> all = with_those_of_libraries(own, planners());
  return all;
}

const auto& solvers() {
  static const std::vector<SolverPlugin> own = {
      made_of<SolverPlugin, Newton, NewtonOptions>("newton", "Block-tridiagonal Newton on the chain."),
      made_of<SolverPlugin, Lbfgs, LbfgsOptions>("lbfgs", "Riemannian L-BFGS, preconditioned by the chain Hessian."),
      made_of<SolverPlugin, GradientDescent, GradientDescentOptions>("gradient_descent",
                                                                     "Riemannian steepest descent."),
      made_of<SolverPlugin, Vfcs, VfcsOptions>("vfcs", "Algorithm 1 of VFCS as printed, including its stopping rule."),
      made_of<SolverPlugin, Georce, GeorceOptions>(
          "georce",
          "GEORCE (arXiv 2505.05961): alternates between the optimality conditions of a discrete energy in a chart."),
      made_of<SolverPlugin, StringMethod, StringMethodOptions>(
          "string", "The string method: steps normal to the path, then equal spacing; no energy."),
      made_of<SolverPlugin, NoSolver>("none",
                                      "The first path unchanged, for post-processors that find the shortest one."),
  };
  static const std::vector<SolverPlugin> all = with_those_of_libraries(own, back_ends());
  return all;
}

const auto& post_processors() {
  static const std::vector<PostProcessorPlugin> all = {
      made_of<PostProcessorPlugin, TracePostProcessor>("trace", "The solved path as a polyline on the mesh.")
          .needing<HasMesh>(),
      made_of<PostProcessorPlugin, StraightenPostProcessor>(
          "straighten", "The exact locally shortest path on the mesh, in the same class as the solved one.")
          .needing<HasMesh>()
          .needing<HasConstantMetric>(),
      made_of<PostProcessorPlugin, OnSurfacePostProcessor, OnSurfaceOptions>(
          "on_surface", "The solved path as a polyline that lies on a smooth domain within a tolerance.")
          .needing<HasLevelSet>(),
      made_of<PostProcessorPlugin, TautPostProcessor, TautOptions>(
          "taut", "The shortest path in its class among obstacles in the plane, or among convex ones in space.")
          .needing<HasConstantMetric>(),
      made_of<PostProcessorPlugin, RefractPostProcessor>(
          "refract", "The least-cost path through the same layers, with Snell's law at every interface.")
          .needing<HasLayers>(),
      made_of<PostProcessorPlugin, RefractCellsPostProcessor>(
          "refract_cells",
          "The locally least-cost path over the cells of a cost map, with Snell's law at every cell side."),
      made_of<PostProcessorPlugin, SwitchbackPostProcessor, SwitchbackOptions>(
          "switchbacks", "The zigzag of given width that a walking path represents on steep slopes.")
          .needing<MixesMoves>(),
  };
  return all;
}

template <class P>
PluginKind kind_of(std::string name, std::string plural, std::string summary, const std::vector<P>& plugins) {
  PluginKind out{std::move(name), std::move(plural), std::move(summary), {}};
  for (const P& p : plugins) out.entries.push_back(&p);
  return out;
}

}  // namespace

std::vector<PluginKind> built_in_kinds() {
  return {
      kind_of("manifold", "manifolds", "where points lie", manifolds()),
      kind_of("obstacle", "obstacles", "regions that paths avoid", obstacles()),
      kind_of("robot", "robots", "bodies that move among obstacles", robots()),
      kind_of("cost", "costs", "the cost of a move from a to b", costs()),
      kind_of("kernel", "kernels", "the convex H of the energy sum H(c / s0)", kernels()),
      kind_of("initializer", "initializers", "how the first path is found", initializers()),
      kind_of("solver", "solvers", "how the path is improved", solvers()),
      kind_of("post_processor", "post_processors", "steps after the solve", post_processors()),
  };
}

const PluginKind* find_kind(std::string_view name) {
  const auto& all = plugin_kinds();
  const auto it =
      std::find_if(all.begin(), all.end(), [&](const PluginKind& k) { return k.name == name || k.plural == name; });
  return it == all.end() ? nullptr : &*it;
}

const PluginKind& kind(std::string_view name) {
  const PluginKind* found = find_kind(name);
  if (found == nullptr) std::abort();  // a name in our own sources
  return *found;
}

const PluginEntry* find_plugin(const PluginKind& kind, std::string_view type) {
  const auto it =
      std::find_if(kind.entries.begin(), kind.entries.end(), [&](const PluginEntry* e) { return e->type == type; });
  return it == kind.entries.end() ? nullptr : *it;
}

std::vector<std::string> types_of(const PluginKind& kind) {
  std::vector<std::string> types;
  for (const PluginEntry* e : kind.entries) types.push_back(e->type);
  return types;
}

}  // namespace leastcost
