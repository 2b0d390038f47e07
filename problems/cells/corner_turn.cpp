// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/corner_turn.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace leastcost {
namespace {

using Eigen::Vector2d;

/// Where a place lies from a corner, in eighths of a turn: even ones along a side, odd ones within a quadrant.
int eighth(const Vector2d& corner, const Vector2d& place) {
  const int x = place[0] > corner[0]   ? 1
                : place[0] < corner[0] ? -1
                                       : 0,
            y = place[1] > corner[1]   ? 1
                : place[1] < corner[1] ? -1
                                       : 0;
  static constexpr std::array<std::array<int, 3>, 3> kEighths = {{{5, 4, 3}, {6, -1, 2}, {7, 0, 1}}};
  return kEighths[static_cast<std::size_t>(x + 1)][static_cast<std::size_t>(y + 1)];
}

/// The cells and sides around a corner, by eighths of a turn.
class Around {
 public:
  Around(const CellMap& map, const Vector2d& corner)
      : map_(map), corner_(corner), column_(*map.line_at(0, corner[0])), row_(*map.line_at(1, corner[1])) {}
  /// Of a quadrant; of a side the lower of both beside it.
  double unit(int at) const {
    if (at % 2 == 0) return std::min(unit((at + 1) % 8), unit((at + 7) % 8));
    const bool right = at == 1 || at == 7, up = at == 1 || at == 3;
    return map_.unit_or_none(up ? row_ : row_ - 1, right ? column_ : column_ - 1);
  }
  int outward(int at) const { return at < 4 ? 1 : -1; }
  Gate gate(int at) const {
    const int axis = at % 4 == 0 ? 0 : 1, line = axis == 0 ? column_ : row_;
    const double here = corner_[axis], there = map_.line(axis, line + outward(at));
    return {axis, corner_[1 - axis], std::min(here, there), std::max(here, there)};
  }

 private:
  const CellMap& map_;
  const Vector2d& corner_;
  int column_, row_;
};

}  // namespace

std::optional<CornerTurn> corner_turn(const CellMap& map, const Vector2d& a, const Vector2d& corner, const Vector2d& b,
                                      bool anticlockwise) {
  const Around around(map, corner);
  const int from = eighth(corner, a), to = eighth(corner, b), step = anticlockwise ? 1 : 7;
  if (from < 0 || to < 0 || from == to) return std::nullopt;
  CornerTurn turn;
  turn.chain.from = a;
  turn.chain.to = b;
  turn.chain.units.push_back(around.unit(from));
  for (int at = from;; at = (at + step) % 8) {
    if (at % 2 == 0) {
      if (!std::isfinite(around.unit(at))) return std::nullopt;
      turn.chain.gates.push_back(around.gate(at));
      turn.outward.push_back(around.outward(at));
    } else if (!std::isfinite(around.unit(at))) {
      return std::nullopt;
    }
    if (at == to) break;
    if (at % 2 != 0 && at != from) turn.chain.units.push_back(around.unit(at));
  }
  turn.chain.units.push_back(around.unit(to));
  return turn;
}

double steepest_fall(const CornerTurn& turn, const Vector2d& corner) {
  const GateChain& chain = turn.chain;
  const std::size_t n = chain.gates.size();
  const Vector2d before = (corner - chain.from).normalized(), after = (chain.to - corner).normalized();
  const double first = chain.units.front() * before[chain.gates[0].axis] * turn.outward[0];
  double rest = -chain.units.back() * after[chain.gates[n - 1].axis] * turn.outward[n - 1];
  for (std::size_t k = n - 1; k > 0; --k) {
    const double unit = chain.units[k];
    if (rest <= -unit) return -unit - rest;
    rest = rest < 0 ? std::sqrt((unit - rest) * (unit + rest)) : unit;
  }
  return -first - rest;
}

}  // namespace leastcost
