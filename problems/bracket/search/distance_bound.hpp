// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "problems/bracket/search/marched.hpp"

namespace leastcost::bracket {

/// The cost from an end to the nodes, or back, nearly, of second order: nothing is proved.
template <Medium M>
struct DistanceField {
  typename M::End end;
  std::vector<double> u;
  Front front;  ///< with the density that it was marched with
};
template <Medium M>
DistanceField<M> distance_field(const M& medium, const Level<M>& level, const typename M::End& end,
                                FastMarching& marching) {
  constexpr int kCorrections = 3;
  DistanceField<M> field{end, {}, front_around(medium, level, end)};
  field.u = march(level, field.front, kCorrections, marching);
  return field;
}

/// A proved lower bound of the cost from an end to any place: min(u, cap) / ratio + offset outside the set around the
/// end, its cone within. Beyond the cap u may be as steep as it likes.
template <Medium M>
struct DistanceBound {
  typename M::End end;
  std::vector<double> u = {};
  double cap = kInfinity, ratio = kInfinity, offset = 0;
};

/// In space the values at the seeds of an end, which no march changes, are lowered as well: all by one factor.
inline void deflate_seeds(const std::vector<double>& ratios, Front& front) {
  double worst = 1;
  for (const int seed : front.seeds) {
    const double ratio = ratios[static_cast<std::size_t>(seed)];
    if (std::isfinite(ratio)) worst = std::max(worst, ratio);
  }
  for (const int seed : front.seeds) front.values[static_cast<std::size_t>(seed)] /= worst;
}

/// The best of some: in the plane the one of the least ratio, in space the one that is highest at the other end,
/// nearly.
template <Medium M>
DistanceBound<M> distance_bound(const Level<M>& level, DistanceField<M> field, const Vector<M::kDimension>& other,
                                double cap, FastMarching& marching) {
  const auto there = static_cast<std::size_t>(level.nodes.find(level.grid.place_at(other)));
  const auto rim = [&](double ratio) {
    return rim_minimum(level.grid, level.nodes, field.end, level.searched, field.u, -1, ratio);
  };
  DistanceBound<M> best{.end = field.end, .cap = cap};
  double highest = -kInfinity;
  std::vector<double> ratios;
  for (int round = 0;; ++round) {
    const double ratio =
        check(level, field.u, field.end, typename M::End(), ratios, marching.look(), field.end.reversed, cap);
    double merit = -ratio;
    if constexpr (M::kDimension == 3) merit = ratio < kInfinity ? field.u[there] / ratio + rim(ratio) : -kInfinity;
    if (round == 0 || merit > highest) {
      highest = merit;
      best.ratio = ratio;
      best.offset = rim(ratio);
      best.u = field.u;
    }
    if (round == M::kFieldDeflations || !(ratio > 1)) return best;
    deflate(level, ratios, field.front);
    if (M::kDimension == 3 && round > 0) deflate_seeds(ratios, field.front);
    field.u = march(level, field.front, 0, marching);
  }
}

}  // namespace leastcost::bracket
