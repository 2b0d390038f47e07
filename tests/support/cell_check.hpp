// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

/// Whether paths keep out of blocked cells, decided in integers. Shares nothing with the library, its reader included.
namespace leastcost::test {

/// The rows of a Moving AI file as they are.
struct CellRows {
  std::vector<std::string> rows;
  bool blocked(std::int64_t row, std::int64_t column) const {
    if (row < 0 || column < 0 || row >= static_cast<std::int64_t>(rows.size()) ||
        column >= static_cast<std::int64_t>(rows[static_cast<std::size_t>(row)].size()))
      return true;
    const char c = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    return c == '@' || c == 'O' || c == 'T' || c == 'W';
  }
};

inline CellRows read_rows(const std::string& file) {
  CellRows out;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && line.substr(0, 3) != "map") continue;
  while (std::getline(in, line)) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (!line.empty()) out.rows.push_back(line);
  }
  return out;
}

constexpr int kPlaces = 40;                                ///< binary digits after the point
constexpr std::int64_t kOne = std::int64_t{1} << kPlaces;  ///< side of a cell
constexpr std::int64_t kSkin = std::int64_t{1} << 12;      ///< 4e-9 of a cell: rounding of a path's coordinates

__extension__ typedef __int128 Wide;  // products of two differences

/// Whether the segment meets the open box, exactly.
inline bool meets_open_box(const std::int64_t (&a)[2], const std::int64_t (&b)[2], const std::int64_t (&low)[2],
                           const std::int64_t (&high)[2]) {
  for (int d = 0; d < 2; ++d)
    if (std::max(a[d], b[d]) <= low[d] || std::min(a[d], b[d]) >= high[d]) return false;
  const Wide dx = b[0] - a[0], dy = b[1] - a[1];
  if (dx == 0 && dy == 0) return true;
  int left = 0, right = 0;
  for (const std::int64_t x : {low[0], high[0]})
    for (const std::int64_t y : {low[1], high[1]}) {
      const Wide side = dx * (y - a[1]) - dy * (x - a[0]);
      left += side >= 0 ? 1 : 0;
      right += side <= 0 ? 1 : 0;
    }
  return left < 4 && right < 4;  // not all corners on one side of the line
}

/// Whether the segment enters a blocked cell deeper than its skin.
inline bool cuts_blocked_cell(const CellRows& map, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const auto exact = [](double x) { return static_cast<std::int64_t>(std::llround(std::ldexp(x, kPlaces))); };
  const std::int64_t a[2] = {exact(from.x()), exact(from.y())}, b[2] = {exact(to.x()), exact(to.y())};
  const auto floor_cell = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  const std::int64_t first = floor_cell(std::min(from.y(), to.y())) - 1,
                     last = floor_cell(std::max(from.y(), to.y())) + 1;
  for (std::int64_t row = first; row <= last; ++row) {
    // Where the line is in this row, generously.
    double left = std::min(from.x(), to.x()), right = std::max(from.x(), to.x());
    if (from.y() != to.y() && last - first > 4) {
      const double slope = (to.x() - from.x()) / (to.y() - from.y());
      const double at = from.x() + slope * (static_cast<double>(row) - from.y()), next = at + slope;
      left = std::max(left, std::min(at, next) - 1);
      right = std::min(right, std::max(at, next) + 1);
    }
    for (std::int64_t column = floor_cell(left) - 1; column <= floor_cell(right) + 1; ++column) {
      if (!map.blocked(row, column)) continue;
      const std::int64_t low[2] = {column * kOne + kSkin, row * kOne + kSkin};
      const std::int64_t high[2] = {(column + 1) * kOne - kSkin, (row + 1) * kOne - kSkin};
      if (meets_open_box(a, b, low, high)) return true;
    }
  }
  return false;
}

/// Least distance of a segment from the closed blocked cells, in cells, where it is below `reach`.
inline double distance_from_cells(const CellRows& map, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                  double reach) {
  const auto to_segment = [](const Eigen::Vector2d& p, const Eigen::Vector2d& s, const Eigen::Vector2d& e) {
    const Eigen::Vector2d way = e - s;
    const double t = way.squaredNorm() > 0 ? std::clamp((p - s).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
    return (s + t * way - p).norm();
  };
  double least = std::numeric_limits<double>::infinity();
  const auto floor_cell = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  const Eigen::Vector2d low = a.cwiseMin(b).array() - reach, high = a.cwiseMax(b).array() + reach;
  for (auto row = static_cast<std::int64_t>(std::floor(low.y())); row <= floor_cell(high.y()); ++row)
    for (auto column = static_cast<std::int64_t>(std::floor(low.x())); column <= floor_cell(high.x()); ++column) {
      if (!map.blocked(row, column)) continue;
      const Eigen::Vector2d corner{static_cast<double>(column), static_cast<double>(row)};
      const Eigen::Vector2d opposite = corner.array() + 1;
      for (const Eigen::Vector2d& p : {a, b})  // of the ends from the box, of its corners from the segment
        least = std::min(least, (p - p.cwiseMax(corner).cwiseMin(opposite)).norm());
      for (const double x : {corner.x(), opposite.x()})
        for (const double y : {corner.y(), opposite.y()}) least = std::min(least, to_segment({x, y}, a, b));
      if (cuts_blocked_cell(map, a, b)) least = 0;
    }
  return least;
}

}  // namespace leastcost::test
