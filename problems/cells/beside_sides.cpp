// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/beside_sides.hpp"

#include <cmath>
#include <optional>

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kHair = 5e-8;  ///< of a cell

/// A line that two places are on.
struct CommonLine {
  int axis, line;
};

std::optional<CommonLine> common_line(const CellMap& map, const Vector2d& a, const Vector2d& b) {
  for (const int axis : {0, 1}) {
    if (a[axis] != b[axis] || a[1 - axis] == b[1 - axis]) continue;
    if (const std::optional<int> line = map.line_at(axis, a[axis])) return CommonLine{axis, *line};
  }
  return std::nullopt;
}

double unit_beside(const CellMap& map, const CommonLine& at, int along, int cell) {
  return at.axis == 0 ? map.unit_or_none(along, cell) : map.unit_or_none(cell, along);
}

/// Inside the cheaper cell; nothing where the move is along no side, or both cells beside it cost the same.
std::optional<Vector2d> inside_cheaper(const CellMap& map, const Vector2d& a, const Vector2d& b) {
  const std::optional<CommonLine> at = common_line(map, a, b);
  if (!at) return std::nullopt;
  Vector2d middle = (a + b) / 2;
  const int along = map.touched(1 - at->axis, middle[1 - at->axis]).first;
  const double before = unit_beside(map, *at, along, at->line - 1), after = unit_beside(map, *at, along, at->line);
  if (before == after) return std::nullopt;
  const double side = map.line(at->axis, at->line);
  const double opposite = map.line(at->axis, before < after ? at->line - 1 : at->line + 1);
  middle[at->axis] = side + kHair * (opposite - side);
  return middle;
}

/// Whether x is what inside_cheaper() puts between a and b.
bool is_hair(const CellMap& map, const Vector2d& a, const Vector2d& x, const Vector2d& b) {
  const std::optional<Vector2d> middle = inside_cheaper(map, a, b);
  return middle && *middle == x;
}

}  // namespace

CellPath beside_sides(const CellMap& map, const CellPath& path) {
  CellPath out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0)
      if (const std::optional<Vector2d> middle = inside_cheaper(map, path[i - 1], path[i])) out.push_back(*middle);
    out.push_back(path[i]);
  }
  return out;
}

Eigen::Matrix2Xd onto_sides(const CellMap& map, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline) {
  Eigen::Matrix2Xd out(2, polyline.cols());
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < polyline.cols(); ++i) {
    const bool inner = i > 0 && i + 1 < polyline.cols();
    if (inner && is_hair(map, polyline.col(i - 1), polyline.col(i), polyline.col(i + 1))) continue;
    out.col(kept++) = polyline.col(i);
  }
  return out.leftCols(kept);
}

}  // namespace leastcost
