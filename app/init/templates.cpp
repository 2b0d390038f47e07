// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/init/templates.hpp"

#include <string_view>
#include <utility>

#include "app/init/sample_data.hpp"

namespace leastcost::app {
namespace {

constexpr std::string_view kPlane = R"(# A least-cost path in the plane. Try: leastcost run THIS_FILE
# All options: leastcost describe run; those of one type: leastcost describe cost metric_tensor
name: plane
manifold:
  type: euclidean
  dimension: 2
  # lower: [0, 0]         # a box that limits the domain
  # upper: [1, 1]
cost:
  type: metric_tensor     # moves along x cost twice those along y
  matrix: [[4, 0], [0, 1]]
ends:
  source: {point: [0, 0]}
  target: {point: [1, 1]}
path:
  points: 64              # free points between the ends
# kernel: expm1_square    # options that are left out have defaults
# solver: newton
)";

constexpr std::string_view kBrachistochrone =
    R"(# The curve of fastest descent: a bead slides without friction from rest.
# The last coordinate is height, up is positive. Time in seconds when lengths are metres.
name: brachistochrone
manifold: {type: euclidean, dimension: 2}
cost:
  type: travel_time
  rule: chute             # exact for straight chutes; midpoint is the rule of VFCS Eq. (21)
  gravity: 9.80665
  start_speed: 0
ends:
  source: {point: [0, 0]}
  target: {point: [3, -2]}
path: {points: 64}
)";

constexpr std::string_view kMesh =
    R"(# A geodesic on a triangle mesh. hill.obj is a sample: write the name of your own file instead, relative to
# this folder.
# To check a mesh: leastcost doctor hill.obj
name: mesh
manifold:
  type: mesh
  file: hill.obj          # your file: OBJ, OFF, PLY or STL
  weld: false             # true: merge vertices with equal positions; 1e-6: those no farther apart, length units
cost: euclidean
ends:                     # a vertex, a point inside a face, or coordinates (moved to the surface)
  source: {vertex: 0}
  target: {vertex: 440}
  # source: {face: 12, barycentric: [0.2, 0.3, 0.5]}
  # source: {point: [0.1, 0.2, 0.3]}
path: {points: auto}      # as many as the first path along edges has
# initializer: dijkstra   # the defaults on a mesh
# solver: lbfgs
# post_process: [trace, straighten]
)";

constexpr std::string_view kRing =
    R"(# A closed path through given points: the waist of a hyperboloid. A ring needs a domain that it can wrap around;
# in the plane it would shrink to a point. Replace the manifold by a mesh with a handle or a waist, and the points by
# points around it.
name: ring
manifold:
  type: implicit
  surface: {type: formula, f: x^2 + y^2 - z^2 - 1}
cost: euclidean
path: {points: 32, ring: true}
initializer:
  type: waypoints
  points: [[1.1, 0, 0.3], [0, 1.1, 0.2], [-1.1, 0, 0.3], [0, -1.1, 0.2]]
)";

constexpr std::string_view kParametric =
    R"yaml(# A geodesic on a surface x(u, v) given by formulas, or by name. Ends and points are (u, v).
# Surfaces with names, and their parameters: leastcost describe manifold parametric
name: parametric
manifold:
  type: parametric
  surface:
    type: formula
    x: (R + r*cos(v))*cos(u)
    y: (R + r*cos(v))*sin(u)
    z: r*sin(v)
    parameters: {R: 2, r: 1}
    period_u: 6.283185307179586   # the period in u; leave out if there is none
    period_v: 6.283185307179586
  # surface: {type: torus, major_radius: 2, minor_radius: 1}   # the same one by name
cost: euclidean
ends:
  source: {point: [0, 0]}
  target: {point: [1, 2]}
path: {points: 64}
# family: {windings: 1}   # also find the paths that go once around, in both directions
)yaml";

constexpr std::string_view kImplicit =
    R"(# A geodesic on a surface f(x, y, z) = 0, by name or as a formula. Ends are points of space near it.
# Surfaces with names, and their parameters: leastcost describe manifold implicit
name: implicit
manifold:
  type: implicit
  surface:
    type: formula
    f: x^2/a^2 + y^2 + z^2 - 1
    parameters: {a: 2}
cost: euclidean
ends:                     # moved onto the surface, at most by the tolerance
  source: {point: [2, 0, 0]}
  target: {point: [0, 0.6, 0.8], tolerance: 1e-6}
path: {points: 64}
# initializer: {type: waypoints, points: [[0, 1, 0]]}   # another way around
)";

constexpr std::string_view kCloud =
    R"(# A geodesic on the smooth surface through a point cloud. cloud.xyz is a sample: write the
# name of your own file instead.
name: cloud
manifold:
  type: point_cloud
  file: cloud.xyz         # your file. XYZ: x y z, or x y z nx ny nz, per line; or PLY
  # normals: estimate     # auto: those of the file if it has them
cost: euclidean
ends:                     # a sample of the file, or coordinates (moved to the surface)
  source: {vertex: 0}
  target: {vertex: 1000}
  # target: {point: [0.1, 0.2, 0.3]}
path: {points: auto}      # as many as the first path along the neighbour graph has
)";

constexpr std::string_view kStudy =
    R"(# A grid of problems, solvers and numbers of points. Try: leastcost study THIS_FILE -o results/comparison
# All options: leastcost describe study. A problem is a configuration, or the name of its file.
name: comparison
points: [16, 64]
solvers: [newton, lbfgs, {name: lbfgs without preconditioner, type: lbfgs, precondition: none}]
repetitions: 3            # for the spread of the times
# max_seconds: 60         # of each cell
problems:
  - name: brachistochrone
    config:
      manifold: {type: euclidean, dimension: 2}
      cost: travel_time
      ends: {source: {point: [0, 0]}, target: {point: [3, -2]}}
  - name: torus
    optimum: 3.00530920550149849   # if known, the tables show the distance from it
    config:
      manifold: {type: parametric, surface: {type: torus, major_radius: 2, minor_radius: 1}}
      cost: euclidean
      ends: {source: {point: [0, 0]}, target: {point: [1, 2]}}
  # - config: my_problem.yaml
)";

constexpr std::string_view kMap =
    R"(# The shortest path on an occupancy map, exactly taut around the corners that it touches. rooms.map is a sample.
# Cell (column, row) of the file is the square from (column, row) to (column + 1, row + 1).
name: map
manifold:
  type: map
  file: rooms.map         # your file: Moving AI, PNG, PGM or map_server YAML
cost: euclidean
ends:
  source: {point: [2.5, 2.5]}
  target: {point: [23.5, 8.5]}
)";

constexpr std::string_view kEarth =
    R"(# The shortest path between two places on the Earth (WGS84). Points are (latitude, longitude) in degrees.
# The cost is in metres.
name: earth
manifold: earth
cost: euclidean
ends:
  source: {point: [51.5, -0.1]}
  target: {point: [35.7, 139.7]}
path: {points: 100}
)";

constexpr std::string_view kTerrain =
    R"(# The quickest walk over a raster of heights, by Tobler's law. hills.asc is a sample, in metres.
# The cost is a time in minutes.
# Points are map coordinates (x, y).
name: terrain
manifold:
  type: terrain
  file: hills.asc         # your file: ESRI grid or CSV; with GDAL also GeoTIFF
cost:
  type: walking
  law: {type: tobler, unit: min}
ends:
  source: {point: [200, 700]}
  target: {point: [1200, 500]}
path: {points: 64}
)";

constexpr std::string_view kCostMap =
    R"(# A path over a raster of costs per unit of length: around a marsh. marsh.csv is a sample; its
# first row is the northernmost.
name: cost_map
manifold: {type: euclidean, lower: [0.5, 0.5], upper: [31.5, 23.5]}
cost:
  type: cost_map
  file: marsh.csv         # your file: ESRI grid or CSV; with GDAL also GeoTIFF
  # interpolation: smooth # default: constant in each cell
ends:
  source: {point: [3, 12]}
  target: {point: [29, 13]}
path: {points: 40}
)";

constexpr std::string_view kWind =
    R"yaml(# The quickest route of a vehicle of given speed in a wind or current (Zermelo's problem).
name: wind
manifold: {type: euclidean, lower: [-1, -4], upper: [11, 4]}
cost:
  type: zermelo
  speed: 1                # of the vehicle through the air or water
  flow: {type: formula, velocity: ["0.6*cos(y)", "0.2*sin(x/2)"]}
  # flow: {type: grid, file: wind.csv}   # a row per node: x, y, u, v
ends:
  source: {point: [0, 0]}
  target: {point: [10, 1]}
path: {points: 64}
)yaml";

constexpr std::string_view kConstraint =
    R"(# A geodesic on the solutions of equations in R^n: here the rotations SO(3) as unit quaternions (w, x, y, z).
# Other sets: leastcost describe manifold constraint
name: constraint
manifold: {type: constraint, set: so3}
cost: euclidean
ends:
  source: {point: [1, 0, 0, 0]}
  target: {point: [0.6, 0, 0.8, 0]}
path: {points: 64}
)";

constexpr std::string_view kSe2 =
    R"(# A robot in the plane drives around a disc and turns: poses (x, y, angle), the angle in radians.
name: se2
manifold: {type: se2, lower: [-4, -4], upper: [4, 4]}
cost: {type: weighted_length, weights: [1, 0.5]}   # a radian of turn costs as much as half a unit of length
obstacles:
  - {type: ball, center: [0, 0], radius: 1}
ends:
  source: {point: [-2, 0, 3]}
  target: {point: [2, 0, -3]}
path: {points: 64}
)";

constexpr std::string_view kSe3 =
    R"(# A body in space moves around a ball and turns: poses (x, y, z, qw, qx, qy, qz), a unit quaternion.
name: se3
manifold: {type: se3, lower: [-5, -5, -5], upper: [5, 5, 5]}
cost: {type: weighted_length, weights: [1, 0.5]}   # a radian of turn costs as much as half a unit of length
obstacles:
  - {type: ball, center: [0.1, 0, 0.2], radius: 1}
ends:
  source: {point: [-2, 0, 0, 1, 0, 0, 0]}
  target: {point: [2, 0.5, 0, 0.6, 0, 0.8, 0]}
path: {points: 64}
)";

constexpr std::string_view kSignedDistance =
    R"(# A geodesic on a surface known by its distances: here sampled on a grid from a formula. A mesh or a
# cloud can be sampled as well.
name: signed_distance
manifold:
  type: signed_distance
  source: {type: implicit, surface: {type: torus, major_radius: 2, minor_radius: 1}}
  # source: {type: mesh, file: part.stl}
  cell: 0.1               # of the grid, in length units
cost: euclidean
ends:                     # moved onto the surface
  source: {point: [3, 0, 0]}
  target: {point: [0.85576, 1.33277, 0.90930]}
initializer: {type: waypoints, points: [[2.2, 1.2, 0.85]]}
path: {points: 100}
)";

constexpr std::string_view kPlan =
    R"(# The shortest plan for a point among obstacles in the plane, proved to be the shortest of all.
# Bodies and arms that move: leastcost init arm, leastcost init se2
name: plan
manifold: {type: euclidean, lower: [-1, -1], upper: [11, 7]}
obstacles:
  - {type: polygon, corners: [[1, 1], [3, 0.5], [2.6, 2], [3.4, 3.2], [1.2, 3.5]]}
  - {type: box, lower: [7.5, -1], upper: [7.6, 3.8]}
  - {type: ball, center: [9, 4.4], radius: 0.5}
clearance: 0.2            # the least distance from all obstacles
cost: euclidean
ends:
  source: {point: [0, 0]}
  target: {point: [10, 6]}
path: {points: 60}
)";

constexpr std::string_view kArm =
    R"(# A motion of a robot arm among balls. A point is a list of joint angles in radians.
# Other arms: leastcost describe robot dh_arm, and from URDF files: leastcost describe robot urdf
name: arm
manifold: robot           # the box of the joint limits
robot: {type: dh_arm, model: panda}
obstacles:
  - {type: ball, center: [0.55, 0, 0.45], radius: 0.12}
  - {type: ball, center: [0.45, 0.35, 0.95], radius: 0.1}
clearance: 0.02           # m, of every part from every obstacle
cost: euclidean
ends:
  source: {point: [-1.2, 0.4, 0, -1.8, 0, 2.2, 0.7]}
  target: {point: [1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5]}
path: {points: 50}
)";

/// For editors: `leastcost init` writes the schema beside the file.
Template starter(const char* name, const char* summary, std::string_view text, std::vector<SampleFile> files = {}) {
  return {name, summary, "# yaml-language-server: $schema=leastcost.schema.json\n" + std::string(text),
          std::move(files)};
}

Template study_starter(const char* name, const char* summary, std::string_view text) {
  Template made = starter(name, summary, text);
  made.command = "study";
  return made;
}

}  // namespace

const std::vector<Template>& templates() {
  static const std::vector<Template> all = {
      starter("plane", "a shortest path in the plane under a metric tensor", kPlane),
      starter("brachistochrone", "the curve of fastest descent", kBrachistochrone),
      starter("wind", "the quickest route in a wind or current", kWind),
      starter("mesh", "a geodesic on a triangle mesh", kMesh, {{"hill.obj", sample_mesh}}),
      starter("cloud", "a geodesic on a point cloud", kCloud, {{"cloud.xyz", sample_cloud}}),
      starter("terrain", "the quickest walk over a raster of heights", kTerrain, {{"hills.asc", sample_heights}}),
      starter("cost_map", "a path over a raster of costs", kCostMap, {{"marsh.csv", sample_costs}}),
      starter("earth", "the shortest path between two places on the Earth", kEarth),
      starter("parametric", "a geodesic on a surface given by formulas in u and v", kParametric),
      starter("implicit", "a geodesic on a surface f(x, y, z) = 0", kImplicit),
      starter("signed_distance", "a geodesic on a surface given by a grid of distances", kSignedDistance),
      starter("constraint", "a geodesic on the solutions of equations in R^n", kConstraint),
      starter("ring", "a closed path through given points", kRing),
      starter("map", "the shortest path on an occupancy map", kMap, {{"rooms.map", sample_rooms}}),
      starter("plan", "the shortest plan for a point among obstacles", kPlan),
      starter("se2", "a motion of a body in the plane", kSe2),
      starter("se3", "a motion of a body in space", kSe3),
      starter("arm", "a motion of a robot arm among obstacles", kArm),
      study_starter("study", "a comparison of solvers on several problems", kStudy),
  };
  return all;
}

}  // namespace leastcost::app
