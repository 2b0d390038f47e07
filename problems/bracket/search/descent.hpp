// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "problems/bracket/cells/spline_place.hpp"
#include "problems/bracket/search/distance_bound.hpp"

namespace leastcost::bracket {

/// Unit vector down the field, of the way on which its costs arrive; not finite where there is none.
template <Medium M>
Vector<M::kDimension> downhill(const Level<M>& level, const std::vector<double>& u, const Vector<M::kDimension>& x) {
  constexpr int N = M::kDimension;
  if (!x.allFinite()) return x;
  const Vector<N> slope = SplinePlace<N>(level.grid, level.nodes, u, level.grid.in_box(x)).slope();
  const int node = level.nodes.find(level.grid.place_at(level.grid.in_box(x)));
  return -level.known.steepest(node, slope.normalized()).normalized();
}

/// Empty where it gets stuck.
template <Medium M>
std::vector<Vector<M::kDimension>> way_down(const Level<M>& level, const DistanceField<M>& field,
                                            const Vector<M::kDimension>& from) {
  using Vector = Vector<M::kDimension>;
  constexpr double kNear = 3, kStep = 0.5;  // cells
  const auto most = static_cast<std::size_t>(128) * static_cast<std::size_t>(level.grid.longest());
  const double step = kStep * level.grid.h;
  std::vector<Vector> way = {from};
  while ((way.back() - field.end.place).norm() > kNear * level.grid.h) {
    const Vector half = way.back() + 0.5 * step * downhill(level, field.u, way.back());
    const Vector next = way.back() + step * downhill(level, field.u, half);
    if (!next.allFinite() || way.size() > most) return {};
    way.push_back(level.grid.in_box(next));
  }
  way.push_back(field.end.place);
  return way;
}

/// Unit vectors across a direction, to all sides.
inline std::vector<Vector<2>> sides_of(const Vector<2>& along) {
  const Vector<2> across(-along[1], along[0]);
  return {across, -across};
}
inline std::vector<Vector<3>> sides_of(const Vector<3>& along) {
  const Vector<3> one = along.unitOrthogonal(), other = along.cross(one);
  return {one, -one, other, -other};
}

/// Ways down a distance field from `from` to the end that it is of, as polylines in the box, from the end on: straight
/// down, and from a little to all sides, for on a ridge between two ways straight down is neither.
template <Medium M>
std::vector<Way<M::kDimension>> ways_down(const Level<M>& level, const DistanceField<M>& field,
                                          const Vector<M::kDimension>& from) {
  using Vector = Vector<M::kDimension>;
  constexpr double kAside = 2;          // cells
  constexpr std::ptrdiff_t kJoin = 24;  // points of the way that a straight move to it leaves out
  const Vector down = downhill(level, field.u, from);
  if (!down.allFinite()) return {};
  std::vector<Vector> asides = sides_of(down);
  asides.insert(asides.begin(), Vector::Zero());
  std::vector<Way<M::kDimension>> out;
  for (const Vector& aside : asides) {
    std::vector<Vector> way = way_down(level, field, level.grid.in_box(from + kAside * level.grid.h * aside));
    if (way.empty()) continue;
    if (!aside.isZero()) {
      way.erase(way.begin(), way.begin() + std::min<std::ptrdiff_t>(kJoin, std::ssize(way) - 1));
      way.insert(way.begin(), from);
    }
    Way<M::kDimension> x(M::kDimension, static_cast<Eigen::Index>(way.size()));
    for (std::size_t k = 0; k < way.size(); ++k) x.col(x.cols() - 1 - static_cast<Eigen::Index>(k)) = way[k];
    out.push_back(std::move(x));
  }
  return out;
}

}  // namespace leastcost::bracket
