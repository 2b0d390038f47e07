// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/global_bound.hpp>

namespace leastcost {

/// The methods that are recommended when nobody asks for others. Their words are the types of plug-ins.
enum class FirstPathMethod { none, straight, dijkstra, cell_graph, grid, eikonal, rrt };
/// How points are moved to the minimum.
enum class SolveMethod { none, newton, lbfgs };
/// How the delivered curve is made of the points.
enum class CurveMethod { on_surface, trace, straighten, taut, refract, refract_cells };
Words<FirstPathMethod> words(FirstPathMethod);
Words<SolveMethod> words(SolveMethod);
Words<CurveMethod> words(CurveMethod);

/// What the choice of methods depends on. facts_of() reads it off the objects of a problem, the catalogue off a
/// configuration, before there are objects.
struct ProblemFacts {
  bool ring = false;                      ///< whether the path is closed
  bool obstacles = false, robot = false;  ///< what is in the way, and for whom
  bool euclidean = false;                 ///< R^d or a box in it, obstacles apart
  bool unbounded = false;                 ///< R^d as a whole
  bool terrain = false;                   ///< a height field over the plane
  bool chart = false;                     ///< a surface given by coordinates, terrain and the Earth included
  bool mesh = false;                      ///< made of triangles
  bool occupancy = false;                 ///< its triangles are the free part of an occupancy map
  bool graph = false;                     ///< edges that a shortest path can follow
  bool level_set = false;                 ///< a surface f = 0
  int coordinates = 0;                    ///< of points; 0: not known yet
  bool constant_metric = false;           ///< the cost is a length in one metric
  bool length = false;                    ///< the cost is a multiple of the length
  bool layers = false;                    ///< the cost has a constant index in each of several layers
  bool cells = false;                     ///< the cost is constant in each cell of a raster
  bool field = false;        ///< the cost depends on the place: paths on several sides may be locally least
  bool pulls_tight = false;  ///< the cost is the length, and paths can be pulled tight among the obstacles
};

/// What is known of the first path when a proof over all paths is considered.
struct FirstPathFacts {
  bool straight = false;      ///< whether the first path is a straight line
  bool states_class = false;  ///< it was given for the sake of its class: waypoints, other routes and the like
};

/// none: for a ring, which has no default.
FirstPathMethod recommended_first_path(const ProblemFacts& facts);

/// Why it is the one, in words that follow its name.
std::string_view why(FirstPathMethod method, const ProblemFacts& facts);
std::string_view why(SolveMethod method);
std::string_view why(CurveMethod method);

/// Whether the post-processors make the least-cost curve of its class by themselves, so that no solver is needed.
bool makes_exact_curves(const ProblemFacts& facts);

/// The solver that a problem with these facts is given; `exact_curve`: a later step finds the curve exactly.
SolveMethod recommended_solver(const ProblemFacts& facts, bool exact_curve);

/// In the order of their application.
std::vector<CurveMethod> recommended_curve(const ProblemFacts& facts);

/// Whether the search through all classes of paths, which follows an exact curve, is made: on meshes, in the plane
/// among obstacles, through layers and cells.
bool proves_over_all_classes(const ProblemFacts& facts, const FirstPathFacts& first, const GlobalProof& asked);

/// Whether a bracket of the least cost in a box is made where that search is not: only on request.
bool brackets_in_box(const ProblemFacts& facts, const GlobalProof& asked);

/// Why there is one of the two, or none, in words that follow its name.
std::string_view why_proof(const ProblemFacts& facts, const FirstPathFacts& first, const GlobalProof& asked);

/// Whether nothing looks at ways beside the straight line, with which the path begins, under a cost that may make one
/// of them cheaper: then a few bows are tried (look_elsewhere).
bool sees_one_way(const ProblemFacts& facts, const FirstPathFacts& first, const GlobalProof& asked);

}  // namespace leastcost
