// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include <leastcost/framework/numbers/dual.hpp>
#include "problems/bracket/cells/nodes.hpp"

namespace leastcost::bracket {

/// A spline around a place: the coefficients of its cell, and where in the cell the place is.
template <int N>
struct SplinePlace {
  bool known = false;  ///< whether all coefficients are there
  Net<N> coefficients = {};
  Vector<N> at = Vector<N>::Zero();

  SplinePlace(const Grid<N>& grid, const Nodes<N>& nodes, const std::vector<double>& u, const Vector<N>& x) {
    const Place<N> cell = grid.place_at(x);
    const int node = nodes.find(cell);
    known = node != nodes.none() && nodes.is_inner(node);
    if (!known) return;
    coefficients = around(nodes, u, node);
    at = (x - grid.node(cell)) / grid.h;
  }

  /// These are NaN where there is no spline.
  double value() const {
    if (!known) return std::numeric_limits<double>::quiet_NaN();
    std::array<double, static_cast<std::size_t>(N)> place;
    for (int k = 0; k < N; ++k) place[static_cast<std::size_t>(k)] = at[k];
    return spline_value<N>(coefficients, place);
  }
  /// Per cell.
  Vector<N> slope() const {
    if (!known) return Vector<N>::Constant(std::numeric_limits<double>::quiet_NaN());
    std::array<Dual<double, N>, static_cast<std::size_t>(N)> place;
    for (std::size_t k = 0; k < place.size(); ++k) {
      place[k] = Dual<double, N>(at[static_cast<int>(k)]);
      place[k].d[k] = 1;
    }
    const Dual<double, N> value = spline_value<N>(coefficients, place);
    Vector<N> out;
    for (int k = 0; k < N; ++k) out[k] = value.d[static_cast<std::size_t>(k)];
    return out;
  }
};

}  // namespace leastcost::bracket
