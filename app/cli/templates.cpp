// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/templates.hpp"

#include <string_view>

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
    R"(# A geodesic on your own triangle mesh: give its file name below, relative to the folder of this configuration.
# To check a mesh: leastcost doctor bunny.obj
name: mesh
manifold:
  type: mesh
  file: bunny.obj         # your file: OBJ, OFF, PLY or STL
  weld: false             # true: merge vertices with equal positions; 1e-6: those no farther apart, length units
cost: euclidean
ends:                     # a vertex, a point inside a face, or coordinates (moved to the surface)
  source: {vertex: 0}
  target: {vertex: 1000}
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
    R"(# A geodesic on the smooth surface through your own point cloud. Give its file below, relative to this folder.
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

/// For editors: `leastcost schema > leastcost.schema.json` beside the file.
Template starter(const char* name, const char* summary, std::string_view text) {
  return {name, summary, "# yaml-language-server: $schema=leastcost.schema.json\n" + std::string(text)};
}

}  // namespace

const std::vector<Template>& templates() {
  static const std::vector<Template> all = {
      starter("plane", "a shortest path in the plane under a metric tensor", kPlane),
      starter("brachistochrone", "the curve of fastest descent", kBrachistochrone),
      starter("mesh", "a geodesic on a triangle mesh", kMesh),
      starter("cloud", "a geodesic on a point cloud", kCloud),
      starter("parametric", "a geodesic on a surface given by formulas in u and v", kParametric),
      starter("implicit", "a geodesic on a surface f(x, y, z) = 0", kImplicit),
      starter("ring", "a closed path through given points", kRing),
      starter("study", "a comparison of solvers on several problems", kStudy),
  };
  return all;
}

}  // namespace leastcost::app
