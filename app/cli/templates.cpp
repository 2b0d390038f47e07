// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/templates.hpp"

namespace leastcost::app {
namespace {

constexpr std::string_view kPlane = R"(# A least-cost path in the plane. Try: leastcost run THIS_FILE
# All options: leastcost describe run; those of one plug-in: leastcost describe cost metric_tensor
name: plane
manifold:
  type: euclidean
  dimension: 2
  # lower: [0, 0]         # a box, if points may not be everywhere
  # upper: [1, 1]
cost:
  type: metric_tensor     # moves along x cost twice those along y
  matrix: [[4, 0], [0, 1]]
ends:
  source: {point: [0, 0]}
  target: {point: [1, 1]}
path:
  points: 64              # free points between the ends
# kernel: expm1_square    # what is left out has a default
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
    R"(# A geodesic on a triangle mesh. The file is relative to the folder of this configuration.
# What is wrong with a mesh, if anything: leastcost doctor bunny.obj
name: mesh
manifold:
  type: mesh
  file: bunny.obj         # OBJ, OFF, PLY or STL
  weld: false             # true: merge vertices with equal positions
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
    R"(# A closed path through given points. In the plane it shrinks to a point, which is reported: a ring needs a
# domain that it can wrap around. Replace the manifold by a mesh with a handle or a waist, and the points by ones around it.
name: ring
manifold: {type: euclidean, dimension: 2}
cost: euclidean
path: {points: 32, ring: true}
initializer:
  type: waypoints
  points: [[1, 0], [0, 1], [-1, 0], [0, -1]]
x-expect-exit: 5          # a note; keys that start with x- mean nothing to the program
)";

}  // namespace

const std::vector<Template>& templates() {
  static const std::vector<Template> all = {
      {"plane", "a shortest path in the plane under a metric tensor", kPlane},
      {"brachistochrone", "the curve of fastest descent", kBrachistochrone},
      {"mesh", "a geodesic on a triangle mesh", kMesh},
      {"ring", "a closed path through given points", kRing},
  };
  return all;
}

}  // namespace leastcost::app
