// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/straight_runs.hpp"

#include <cmath>
#include <optional>

#include "problems/cells/gate_chain.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kNoDearer = 1e-13;  ///< of the cost

/// Places of a path that stay, and the cost of a unit of length on the way to each but the first.
struct Turns {
  CellPath places;
  std::vector<double> units;
};

double unit_of(const CellMap& map, const Vector2d& a, const Vector2d& b) {
  const auto leg = map.leg(a, b);
  return leg ? leg->unit : std::numeric_limits<double>::infinity();
}

CellPath cut(const CellMap& map, const CellPath& polyline) {
  Eigen::Matrix2Xd columns(2, static_cast<Eigen::Index>(polyline.size()));
  for (std::size_t i = 0; i < polyline.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = polyline[i];
  return cut_at_sides(map, columns);
}

/// Without places between cells of equal cost that a straight move replaces.
Turns turns_of(const CellMap& map, const CellPath& path) {
  Turns turns{{path.front()}, {}};
  double run = 0;  // cost from the last turn to path[i]
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double unit = unit_of(map, path[i - 1], path[i]);
    run += unit * (path[i] - path[i - 1]).norm();
    if (i + 1 < path.size() && unit_of(map, path[i], path[i + 1]) == unit) {
      const double next = run + unit * (path[i + 1] - path[i]).norm();
      if (cost_of(map, cut(map, {turns.places.back(), path[i + 1]})) <= next * (1 + kNoDearer)) continue;
    }
    turns.places.push_back(path[i]);
    turns.units.push_back(unit);
    run = 0;
  }
  return turns;
}

/// The side between two costs on which a turn may move; nothing for one that stays.
std::optional<Gate> side_of(const CellMap& map, const Vector2d& x) {
  const std::optional<int> vertical = map.line_at(0, x[0]), horizontal = map.line_at(1, x[1]);
  if (vertical.has_value() == horizontal.has_value()) return std::nullopt;
  const int along = vertical ? 1 : 0;
  const CellRange cell = map.touched(along, x[along]);
  return Gate{along, x[1 - along], map.line(along, cell.first), map.line(along, cell.first + 1)};
}

/// Moves the turns between two that stay to where they cost least.
void settle(const CellMap& map, Turns& turns, std::size_t from, std::size_t to) {
  if (to < from + 2) return;
  GateChain chain;
  chain.from = turns.places[from];
  chain.to = turns.places[to];
  std::vector<double> s;
  for (std::size_t i = from + 1; i <= to; ++i) {
    chain.units.push_back(turns.units[i - 1]);
    if (i == to) break;
    chain.gates.push_back(*side_of(map, turns.places[i]));
    s.push_back(turns.places[i][chain.gates.back().axis]);
  }
  polish(chain, s);
  for (std::size_t i = from + 1; i < to; ++i) turns.places[i] = chain.gates[i - from - 1].at(s[i - from - 1]);
}

}  // namespace

CellPath with_straight_runs(const CellMap& map, const CellPath& path) {
  if (path.size() < 3) return path;
  Turns turns = turns_of(map, path);
  std::size_t from = 0;
  for (std::size_t i = 1; i < turns.places.size(); ++i) {
    const bool moves =
        i + 1 < turns.places.size() && turns.units[i - 1] != turns.units[i] && side_of(map, turns.places[i]);
    if (moves) continue;
    settle(map, turns, from, i);
    from = i;
  }
  return cut(map, turns.places);
}

}  // namespace leastcost
