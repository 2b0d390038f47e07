// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/descent.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <leastcost/framework/numbers/dual.hpp>

namespace leastcost::bracket {
namespace {

using Eigen::Vector2d;

/// Unit vector down the field, of the way on which its costs arrive; not finite where there is none.
Vector2d downhill(const Level& level, const std::vector<double>& u, const Vector2d& x) {
  const CellGrid& grid = level.grid;
  const Vector2d inside = grid.in_box(x);
  const int i = grid.column_at(inside[0]), j = grid.row_at(inside[1]);
  const auto node = static_cast<std::size_t>(grid.id(i, j));
  using Slope = Dual<double, 2>;
  Slope a((inside[0] - grid.x(i)) / grid.h), b((inside[1] - grid.y(j)) / grid.h);
  a.d[0] = 1;
  b.d[1] = 1;
  const Slope value = spline_value<Slope>(u, grid.stride(), node, a, b);
  const Vector2d p = Vector2d(value.d[0], value.d[1]).normalized();
  return -level.steepest(node, p).normalized();
}

/// Empty where it gets stuck.
std::vector<Vector2d> way_down(const Level& level, const DistanceField& field, const Vector2d& from) {
  const CellGrid& grid = level.grid;
  constexpr double kNear = 3, kStep = 0.5;  // cells
  const auto most = static_cast<std::size_t>(64) * static_cast<std::size_t>(grid.nx + grid.ny);
  std::vector<Vector2d> way = {from};
  while ((way.back() - field.region.place).norm() > kNear * grid.h) {
    const double step = kStep * grid.h;
    const Vector2d half = way.back() + 0.5 * step * downhill(level, field.u, way.back());
    const Vector2d next = grid.in_box(way.back() + step * downhill(level, field.u, half));
    if (!next.allFinite() || way.size() > most) return {};
    way.push_back(next);
  }
  way.push_back(field.region.place);
  return way;
}

}  // namespace

std::vector<Eigen::Matrix2Xd> ways_down(const Level& level, const DistanceField& field, const Vector2d& from) {
  constexpr double kAside = 2;          // cells
  constexpr std::ptrdiff_t kJoin = 24;  // points of the way that a straight move to it leaves out
  const CellGrid& grid = level.grid;
  const Vector2d down = downhill(level, field.u, from), across(-down[1], down[0]);
  std::vector<Eigen::Matrix2Xd> out;
  for (const double aside : {0.0, kAside, -kAside}) {
    const Vector2d begin = grid.in_box(from + aside * grid.h * across);
    if (!begin.allFinite()) continue;
    std::vector<Vector2d> way = way_down(level, field, begin);
    if (way.empty()) continue;
    if (aside != 0) way.erase(way.begin(), way.begin() + std::min<std::ptrdiff_t>(kJoin, std::ssize(way) - 1));
    if (aside != 0) way.insert(way.begin(), from);
    Eigen::Matrix2Xd x(2, static_cast<Eigen::Index>(way.size()));
    for (std::size_t k = 0; k < way.size(); ++k) x.col(x.cols() - 1 - static_cast<Eigen::Index>(k)) = way[k];
    out.push_back(std::move(x));
  }
  return out;
}

}  // namespace leastcost::bracket
