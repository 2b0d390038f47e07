// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/recipes/methods.hpp>

#include <array>
#include <variant>

namespace leastcost {
namespace {

bool is_plane(const ProblemFacts& facts) { return facts.euclidean && facts.coordinates == 2; }

/// Layers and cells refract a path only if there are no obstacles and no robot.
bool is_free(const ProblemFacts& facts) { return facts.euclidean && !facts.ring && !facts.robot && !facts.obstacles; }

bool refracts(const ProblemFacts& facts) { return is_free(facts) && facts.layers; }
bool refracts_in_cells(const ProblemFacts& facts) { return is_free(facts) && facts.cells; }

bool is_asked_for(const GlobalProof& proof) { return std::holds_alternative<GlobalBudget>(proof); }

}  // namespace

Words<FirstPathMethod> words(FirstPathMethod) {
  static constexpr std::array<Word<FirstPathMethod>, 7> kWords = {{{FirstPathMethod::none, ""},
                                                                   {FirstPathMethod::straight, "straight"},
                                                                   {FirstPathMethod::dijkstra, "dijkstra"},
                                                                   {FirstPathMethod::cell_graph, "cell_graph"},
                                                                   {FirstPathMethod::grid, "grid"},
                                                                   {FirstPathMethod::eikonal, "eikonal"},
                                                                   {FirstPathMethod::rrt, "rrt"}}};
  return kWords;
}

Words<SolveMethod> words(SolveMethod) {
  static constexpr std::array<Word<SolveMethod>, 3> kWords = {
      {{SolveMethod::none, "none"}, {SolveMethod::newton, "newton"}, {SolveMethod::lbfgs, "lbfgs"}}};
  return kWords;
}

Words<CurveMethod> words(CurveMethod) {
  static constexpr std::array<Word<CurveMethod>, 6> kWords = {{{CurveMethod::on_surface, "on_surface"},
                                                               {CurveMethod::trace, "trace"},
                                                               {CurveMethod::straighten, "straighten"},
                                                               {CurveMethod::taut, "taut"},
                                                               {CurveMethod::refract, "refract"},
                                                               {CurveMethod::refract_cells, "refract_cells"}}};
  return kWords;
}

FirstPathMethod recommended_first_path(const ProblemFacts& facts) {
  if (facts.ring) return FirstPathMethod::none;
  if (refracts_in_cells(facts) && is_plane(facts)) return FirstPathMethod::cell_graph;
  if (!facts.robot) {
    if ((is_plane(facts) || facts.terrain) && facts.field) return FirstPathMethod::eikonal;
    if (facts.obstacles && facts.chart) return FirstPathMethod::eikonal;
    if (facts.obstacles && is_plane(facts)) return FirstPathMethod::grid;
  }
  if (facts.robot || facts.obstacles) return FirstPathMethod::rrt;
  return facts.graph ? FirstPathMethod::dijkstra : FirstPathMethod::straight;
}

std::string_view why(FirstPathMethod method, const ProblemFacts& facts) {
  switch (method) {
    case FirstPathMethod::none: return "because a ring has no default first path: give one";
    case FirstPathMethod::straight: return "because there are no obstacles and no edges to follow";
    case FirstPathMethod::dijkstra: return "because the shortest path along the edges is near the least-cost path";
    case FirstPathMethod::cell_graph: return "because the cost is constant in each cell of a raster";
    case FirstPathMethod::grid: return "because it considers paths on all sides of obstacles in the plane";
    case FirstPathMethod::eikonal:
      return facts.field ? "because the cost varies with position, and it considers paths on all sides"
                         : "because it considers paths on all sides of obstacles in a chart";
    case FirstPathMethod::rrt:
      return facts.robot ? "because a robot moves in a configuration space"
                         : "because it finds paths among obstacles in any number of coordinates";
  }
  return "";
}

std::string_view why(SolveMethod method) {
  switch (method) {
    case SolveMethod::none: return "because a post-processor makes the curve from the first path";
    case SolveMethod::newton: return "because second derivatives are known, and it needs the fewest iterations";
    case SolveMethod::lbfgs: return "because the energy on a mesh has kinks";
  }
  return "";
}

std::string_view why(CurveMethod method) {
  switch (method) {
    case CurveMethod::on_surface: return "because the path has to lie on the surface between its points as well";
    case CurveMethod::trace: return "because the path has to lie on the triangles between its points as well";
    case CurveMethod::straighten: return "because a length on a mesh is least where the unfolded path is straight";
    case CurveMethod::taut: return "because a length among obstacles is least where the path is pulled tight";
    case CurveMethod::refract: return "because paths are straight in each layer and bend between layers";
    case CurveMethod::refract_cells: return "because paths are straight in each cell and bend at its sides";
  }
  return "";
}

bool makes_exact_curves(const ProblemFacts& facts) {
  return facts.pulls_tight || refracts(facts) || refracts_in_cells(facts);
}

SolveMethod recommended_solver(const ProblemFacts& facts, bool exact_curve) {
  if (exact_curve) return SolveMethod::none;
  return facts.mesh ? SolveMethod::lbfgs : SolveMethod::newton;
}

std::vector<CurveMethod> recommended_curve(const ProblemFacts& facts) {
  std::vector<CurveMethod> steps;
  if (facts.level_set) steps.push_back(CurveMethod::on_surface);
  if (facts.mesh) steps.push_back(CurveMethod::trace);
  if (facts.mesh && facts.constant_metric) steps.push_back(CurveMethod::straighten);
  if (facts.pulls_tight) steps.push_back(CurveMethod::taut);
  if (refracts(facts)) steps.push_back(CurveMethod::refract);
  if (refracts_in_cells(facts)) steps.push_back(CurveMethod::refract_cells);
  return steps;
}

bool proves_over_all_classes(const ProblemFacts& facts, const FirstPathFacts& first, const GlobalProof& asked) {
  if (facts.ring || std::holds_alternative<GlobalOff>(asked)) return false;
  if (refracts(facts) && first.straight) return true;
  if (refracts_in_cells(facts)) return true;
  if (first.states_class) return false;
  if (refracts(facts)) return true;
  if (facts.pulls_tight && facts.coordinates == 2) return true;
  return facts.mesh && facts.constant_metric && (!facts.occupancy || is_asked_for(asked));
}

bool brackets_in_box(const ProblemFacts& facts, const GlobalProof& asked) {
  return is_asked_for(asked) && (facts.euclidean || facts.terrain);
}

std::string_view why_proof(const ProblemFacts& facts, const FirstPathFacts& first, const GlobalProof& asked) {
  if (proves_over_all_classes(facts, first, asked)) {
    if (refracts(facts)) return "because all paths through the layers can be bounded";
    if (refracts_in_cells(facts)) return "because all paths through the cells can be bounded";
    if (facts.mesh) return "because all paths on a mesh can be searched under a constant metric";
    return "because all paths around obstacles in the plane can be searched";
  }
  if (brackets_in_box(facts, asked)) return "because certificate.global asks for a bracket in the box";
  if (std::holds_alternative<GlobalOff>(asked)) return "because it is switched off";
  if (facts.ring) return "because such a proof needs two ends, and a ring has none";
  if (proves_over_all_classes(facts, {}, asked)) return "because the first path states which class is wanted";
  if (facts.occupancy && facts.constant_metric)
    return "because on an occupancy map it is made on request only (certificate: {global: {tolerance: 1e-3}})";
  const bool flat = facts.euclidean && (facts.coordinates == 2 || facts.coordinates == 3);
  return flat || facts.terrain ? "because no search over all paths exists for this domain and cost; in a box the least "
                                 "cost can be bracketed (certificate: "
                                 "{global: {tolerance: 1e-3}})"
                               : "because no search over all paths exists for this domain and cost";
}

bool sees_one_way(const ProblemFacts& facts, const FirstPathFacts& first, const GlobalProof& asked) {
  return facts.field && first.straight && !facts.ring && !facts.robot && !facts.obstacles &&
         !proves_over_all_classes(facts, first, asked) && !brackets_in_box(facts, asked);
}

}  // namespace leastcost
