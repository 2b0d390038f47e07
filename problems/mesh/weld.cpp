// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/weld.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <unordered_map>

namespace leastcost {
namespace {

/// Cells of a grid over space. Doubles, as coordinates over a small width are beyond every integer.
using Cell = std::array<double, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::size_t hash = 0;
    for (const double index : cell) hash = hash * 1000003U ^ std::hash<double>()(index);
    return hash;
  }
};

/// Positions by cells that are wider than the distance within which others are asked for.
class NearGrid {
 public:
  NearGrid(std::span<const Eigen::Vector3d> positions, double distance) : positions_(positions), distance_(distance) {}

  void add(std::int32_t i) {
    const Eigen::Vector3d& p = position(i);
    cells_[{cell(p[0]), cell(p[1]), cell(p[2])}].push_back(i);
  }

  /// The lowest that was added and lies within the distance of p; -1: none.
  std::int32_t lowest_near(const Eigen::Vector3d& p) const {
    std::array<std::array<double, 2>, 3> range{};  // rounding is monotone, so what lies within is in one of these
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = p[static_cast<Eigen::Index>(k)];
      range[k] = {cell(x - distance_), cell(x + distance_)};
    }
    const auto ways = [&](std::size_t k) { return range[k][0] == range[k][1] ? 1U : 2U; };
    std::int32_t lowest = -1;
    for (std::size_t a = 0; a < ways(0); ++a) {
      for (std::size_t b = 0; b < ways(1); ++b) {
        for (std::size_t c = 0; c < ways(2); ++c) look_into({range[0][a], range[1][b], range[2][c]}, p, lowest);
      }
    }
    return lowest;
  }

 private:
  static constexpr double kWidth = 8;  // distances

  const Eigen::Vector3d& position(std::int32_t i) const { return positions_[static_cast<std::size_t>(i)]; }
  double cell(double x) const { return std::floor(x / (kWidth * distance_)) + 0.0; }  // no -0

  void look_into(const Cell& where, const Eigen::Vector3d& p, std::int32_t& lowest) const {
    const auto found = cells_.find(where);
    if (found == cells_.end()) return;
    for (const std::int32_t i : found->second)
      if ((lowest < 0 || i < lowest) && (position(i) - p).norm() <= distance_) lowest = i;
  }

  std::span<const Eigen::Vector3d> positions_;
  double distance_;
  std::unordered_map<Cell, std::vector<std::int32_t>, CellHash> cells_;
};

}  // namespace

std::vector<std::int32_t> lowest_equal(std::span<const Eigen::Vector3d> positions) {
  struct Entry {
    double x;
    std::int32_t index;
  };
  const auto place = [&](const Entry& e) -> const Eigen::Vector3d& {
    return positions[static_cast<std::size_t>(e.index)];
  };
  std::vector<Entry> entries;
  entries.reserve(positions.size());
  for (const Eigen::Vector3d& p : positions) entries.push_back({p.x(), static_cast<std::int32_t>(entries.size())});
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    if (a.x != b.x) return a.x < b.x;
    const Eigen::Vector3d &p = place(a), &q = place(b);
    return std::tie(p.y(), p.z(), a.index) < std::tie(q.y(), q.z(), b.index);
  });
  std::vector<std::int32_t> result(positions.size());
  const Entry* group = nullptr;
  for (const Entry& e : entries) {
    if (!group || place(*group) != place(e)) group = &e;
    result[static_cast<std::size_t>(e.index)] = group->index;
  }
  return result;
}

std::vector<std::int32_t> lowest_within(std::span<const Eigen::Vector3d> positions, double distance) {
  NearGrid grid(positions, distance);
  std::vector<std::int32_t> result;
  result.reserve(positions.size());
  for (const Eigen::Vector3d& p : positions) {
    const std::int32_t i = static_cast<std::int32_t>(result.size()), near = grid.lowest_near(p);
    result.push_back(near < 0 ? i : near);
    if (near < 0) grid.add(i);
  }
  return result;
}

}  // namespace leastcost
