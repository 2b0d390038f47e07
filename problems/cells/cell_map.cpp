// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/cell_map.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kOnLine = 8 * std::numeric_limits<double>::epsilon();  ///< of a coordinate, or of a cell

std::vector<double> lines_of(double corner, double side, int cells) {
  std::vector<double> lines(static_cast<std::size_t>(cells) + 1);
  for (int k = 0; k <= cells; ++k) lines[static_cast<std::size_t>(k)] = corner + k * side;
  return lines;
}

/// The part of lines that a range leaves, its ends among them, and which cell the first one left is.
std::pair<std::vector<double>, int> clipped(const std::vector<double>& lines, double low, double high) {
  low = std::max(low, lines.front());
  high = std::min(high, lines.back());
  if (!(low < high)) return {{0}, 0};
  const auto first = std::upper_bound(lines.begin(), lines.end(), low),
             last = std::lower_bound(lines.begin(), lines.end(), high);
  std::vector<double> out = {low};
  out.insert(out.end(), first, last);
  out.push_back(high);
  return {out, static_cast<int>(first - lines.begin()) - 1};
}

/// The coordinate of the line that is as near as rounding, or the coordinate itself.
double on_line(const std::vector<double>& lines, double coordinate) {
  const auto next = std::lower_bound(lines.begin(), lines.end(), coordinate);
  for (auto near = next == lines.begin() ? next : next - 1; near != lines.end() && near <= next; ++near) {
    const double cell = near + 1 == lines.end() ? *near - *(near - 1) : *(near + 1) - *near;
    if (std::abs(*near - coordinate) <= kOnLine * std::max(cell, std::abs(coordinate))) return *near;
  }
  return coordinate;
}

/// The places of a move that are on lines of an axis, by the share of the move before them.
void add_crossings(const CellMap& map, int axis, const Vector2d& from, const Vector2d& to,
                   std::vector<std::pair<double, Vector2d>>& found) {
  const std::vector<double>& lines = map.lines(axis);
  const double low = std::min(from[axis], to[axis]), high = std::max(from[axis], to[axis]);
  const auto end = std::lower_bound(lines.begin(), lines.end(), high);
  for (auto line = std::upper_bound(lines.begin(), lines.end(), low); line < end; ++line) {
    const double share = (*line - from[axis]) / (to[axis] - from[axis]);
    Vector2d place = from + share * (to - from);
    place[axis] = *line;
    place[1 - axis] = on_line(map.lines(1 - axis), place[1 - axis]);
    found.emplace_back(share, place);
  }
}

}  // namespace

CellMap::CellMap(const RasterGrid& raster)
    : x_(lines_of(raster.corner[0], raster.cell[0], raster.columns)),
      y_(lines_of(raster.corner[1], raster.cell[1], raster.rows)),
      units_(raster.values),
      source_(raster.source) {
  for (double& unit : units_)
    if (!std::isfinite(unit)) unit = kInfinite;
}

CellMap CellMap::within(const Eigen::AlignedBox2d& box) const {
  CellMap out;
  int column = 0, row = 0;
  std::tie(out.x_, column) = clipped(x_, box.min()[0], box.max()[0]);
  std::tie(out.y_, row) = clipped(y_, box.min()[1], box.max()[1]);
  out.source_ = source_;
  if (out.empty()) return out;
  for (int r = 0; r < out.rows(); ++r)
    for (int c = 0; c < out.columns(); ++c) out.units_.push_back(unit(row + r, column + c));
  return out;
}

double CellMap::least_unit() const {
  return units_.empty() ? kInfinite : *std::min_element(units_.begin(), units_.end());
}

CellRange CellMap::touched(int axis, double coordinate) const {
  const std::vector<double>& all = lines(axis);
  if (!(coordinate >= all.front() && coordinate <= all.back())) return {};
  const int next = static_cast<int>(std::lower_bound(all.begin(), all.end(), coordinate) - all.begin());
  const int last = static_cast<int>(all.size()) - 2;
  if (all[as_index(next)] != coordinate) return {next - 1, next - 1};
  return {std::max(0, next - 1), std::min(last, next)};
}

std::optional<int> CellMap::line_at(int axis, double coordinate) const {
  const std::vector<double>& all = lines(axis);
  const auto at = std::lower_bound(all.begin(), all.end(), coordinate);
  if (at == all.end() || *at != coordinate) return std::nullopt;
  return static_cast<int>(at - all.begin());
}

std::optional<CellLeg> CellMap::leg(const Vector2d& a, const Vector2d& b) const {
  const CellRange columns = touched(0, a[0]).common(touched(0, b[0])), rows = touched(1, a[1]).common(touched(1, b[1]));
  CellLeg best{0, 0, kInfinite, 0};
  for (int row = rows.first; row <= rows.last; ++row)
    for (int column = columns.first; column <= columns.last; ++column)
      if (unit(row, column) < best.unit) best = {row, column, unit(row, column), 0};
  if (best.unit == kInfinite) return std::nullopt;
  best.cost = best.unit * (b - a).norm();
  return best;
}

std::string CellMap::why_no_end(const Vector2d& place) const {
  if (leg(place, place)) return "";
  const bool outside = empty() || touched(0, place[0]).empty() || touched(1, place[1]).empty();
  return point_text(place) + (outside ? " is outside the cells" : " is in a cell without data") +
         (source_.empty() ? "" : " of " + source_);
}

CellPath cut_at_sides(const CellMap& map, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline) {
  CellPath path = {polyline.col(0)};
  const Eigen::Index last = polyline.cols() - 1;
  std::vector<std::pair<double, Vector2d>> found;
  for (Eigen::Index i = 0; i < last; ++i) {
    Vector2d next = polyline.col(i + 1);
    if (i + 1 < last)
      for (const int axis : {0, 1}) next[axis] = on_line(map.lines(axis), next[axis]);
    found.clear();
    for (const int axis : {0, 1}) add_crossings(map, axis, path.back(), next, found);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [share, place] : found)
      if (place != path.back()) path.push_back(place);
    if (next != path.back()) path.push_back(next);
  }
  return path;
}

double cost_of(const CellMap& map, const CellPath& path) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto leg = map.leg(path[i], path[i + 1]);
    if (!leg) return kInfinite;
    sum += leg->cost;
  }
  return sum;
}

}  // namespace leastcost
