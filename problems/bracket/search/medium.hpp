// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <vector>

#include "problems/bracket/cells/nodes.hpp"
#include "problems/bracket/search/fast_marching.hpp"
#include "problems/bracket/search/front.hpp"

namespace leastcost::bracket {

/// The part of a grid that a search looks at.
template <int N>
struct Part {
  Grid<N> grid;
  Nodes<N> nodes;
  std::vector<double> density;          ///< per node: what fronts are marched with; infinite where they do not go
  std::vector<unsigned char> searched;  ///< per node: its cell may hold a cheaper path, the inequality is checked in it
  std::vector<int> cells;               ///< those nodes
};

/// What paths run through: a cost, with what is proved of it around an end of the path (End: a set of cells with a
/// bound of the cost from the end), and what it keeps of the nodes and cells of one grid (Known). A new kind of cost is
/// a new Medium.
///
/// kIsotropic: moves cost the same in all directions, so that fronts have an order. kSeedsGiveWay: deflation changes
/// values at the seeds of an end as well. kBisectorDeflations, kFieldDeflations, kPatience: rounds of it.
template <class M>
concept Medium = requires(const M& medium, const Grid<M::kDimension>& grid, const Vector<M::kDimension>& x,
                          const Way<M::kDimension>& way, const typename M::End& end, Part<M::kDimension>& part,
                          Front& front, FastMarching& marching, std::vector<double>& u) {
  { M::kIsotropic } -> std::convertible_to<bool>;
  { M::kSeedsGiveWay } -> std::convertible_to<bool>;
  { M::kBisectorDeflations + M::kFieldDeflations + M::kPatience } -> std::convertible_to<int>;
  /// n, or 1 where a dual norm says the rest; not finite where there are no moves.
  { medium.density(x) } -> std::convertible_to<double>;
  /// `reversed`: of the cost to the end.
  { medium.end(grid, x, 3, true) } -> std::same_as<typename M::End>;
  /// Of the best move from the end to a place near it, where the front's density is that.
  { medium.cost_near(end, grid, x, 1.0) } -> std::convertible_to<double>;
  { medium.polyline_above(way) } -> std::convertible_to<double>;

  requires requires(typename M::Known known, const typename M::Known& it) {
    known.begin(medium, part);                // a grid, of whose nodes and cells nothing is known yet
    known.learn_node(medium, part, 0, x);     // one that fronts go to, or would
    known.end_of_nodes(part);                 // there are no more of them
    known.learn_cell(medium, part, 0, true);  // in the order of part.cells; whether the grid is fine
    known.end_of_cells(medium, part);
    /// The dual norm of a gradient, its length where there is a density, and the move along which it is largest.
    { it.size(0, x, true) } -> std::convertible_to<double>;
    { it.steepest(0, x) } -> std::convertible_to<Vector<M::kDimension>>;
    /// The least ratio for which the k-th cell is proved, of a spline with these coefficients.
    { it.ratio(part, Net<M::kDimension>(), 1.0, 0, true, Blocked<M::kDimension>()) } -> std::convertible_to<double>;
    it.march(part, front, u, marching);
    it.spread(part, u);  // excesses of ratios at nodes, to those around them
  };
};

}  // namespace leastcost::bracket
