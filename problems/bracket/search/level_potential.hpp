// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include <leastcost/problems/bracket/search/box_bracket.hpp>
#include "problems/bracket/cells/spline_place.hpp"
#include "problems/bracket/search/distance_bound.hpp"

namespace leastcost::bracket {

/// A spline on the nodes of a level.
template <Medium M, int N = M::kDimension>
class LevelPotential final : public BoxPotential<N> {
 public:
  LevelPotential(std::shared_ptr<const Level<M>> level, DistanceBound<M> u, const typename M::End& s,
                 const typename M::End& t)
      : level_(std::move(level)), u_(std::move(u)), s_(s), t_(t) {}

  bool is_checked(const Vector<N>& x) const override {
    const Place<N> cell = level_->grid.place_at(x);
    return level_->searched[static_cast<std::size_t>(level_->nodes.find(cell))] != 0 && !is_in(s_, cell) &&
           !is_in(t_, cell) && (u_.cap == kInfinity || std::abs(value(x)) < u_.cap);
  }
  double value(const Vector<N>& x) const override { return place(x).value(); }
  Vector<N> gradient(const Vector<N>& x) const override { return place(x).slope() / level_->grid.h; }
  double ratio() const override { return u_.ratio; }
  Box<N> searched() const override {
    const Grid<N>& grid = level_->grid;
    Box<N> out;
    for (const int cell : level_->cells)
      for (const int far : {0, 1}) {
        Vector<N> corner;
        for (int k = 0; k < N; ++k)
          corner[k] = grid.corner[k] + grid.h * (level_->nodes.place(cell)[static_cast<std::size_t>(k)] - 1 + far);
        out.extend(corner);
      }
    return out;
  }

 private:
  static bool is_in(const typename M::End& end, const Place<N>& cell) { return end.valid && end.holds(cell); }
  SplinePlace<N> place(const Vector<N>& x) const { return {level_->grid, level_->nodes, u_.u, x}; }

  std::shared_ptr<const Level<M>> level_;
  DistanceBound<M> u_;
  typename M::End s_, t_;
};

}  // namespace leastcost::bracket
