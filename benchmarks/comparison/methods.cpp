// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/methods.hpp"

namespace leastcost::comparison {

const std::vector<MethodEntry>& all_methods() {
  static const std::vector<MethodEntry> entries = {
      {"Dijkstra", Kind::field, "shortest path along edges", make_dijkstra},
      {"FMM", Kind::field, "first-order fast marching, path traced down the field", make_fast_marching},
      {"Heat", Kind::field, "heat method on the intrinsic Delaunay triangulation, path traced", make_heat},
      {"CH", Kind::exact, "Chen and Han: windows level by level, one angle one split", make_chen_han},
      {"ICH", Kind::exact, "Xin and Wang: windows by distance, filtered at vertices", make_improved_chen_han},
      {"VTP", Kind::exact, "Qin et al.: window lists, vertex by vertex", make_vertex_oriented},
      {"SR", Kind::local, "Kanai and Suzuki: Steiner points around the path, refined", make_selective_refinement},
      {"LS", Kind::local, "Martinez et al.: straightens one point after the other", make_local_straightening},
      {"DE", Kind::local, "differential evolution of the crossings", make_differential_evolution},
      {"SLO", Kind::local, "chain with squared length, traced", make_squared_length},
      {"LLM", Kind::local, "L-BFGS on the crossings, sequence changed at vertices", make_crossing_lbfgs},
      {"VFCS", Kind::local, "the paper's: chain with exp kernel, L-BFGS, traced", make_vfcs},
      {"ours", Kind::exact, "default of find_path: straightened, proved by goal-directed windows", make_ours},
  };
  return entries;
}

}  // namespace leastcost::comparison
