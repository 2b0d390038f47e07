// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/occupancy/free_mesh.hpp"

#include <algorithm>

namespace leastcost {
namespace {

/// A vertex on the lower or the upper side of a box.
struct SidePoint {
  int column;
  std::int32_t vertex;
};
using Side = std::vector<SidePoint>;  ///< ascending, from corner to corner

class Mesher {
 public:
  Mesher(const OccupancyGrid& grid, const std::vector<CellBox>& boxes)
      : grid_(grid), boxes_(boxes), lower_(boxes.size()), upper_(boxes.size()) {}

  FreeMesh mesh() {
    join_boxes();
    FreeMesh out;
    out.face_begin.push_back(0);
    out.triangles.polygon_begin.push_back(0);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      close(lower_[i], boxes_[i], boxes_[i].row);
      close(upper_[i], boxes_[i], boxes_[i].row_end);
      fill(lower_[i], upper_[i], out.triangles);
      out.face_begin.push_back(static_cast<std::int32_t>(out.triangles.polygon_begin.size()) - 1);
    }
    out.triangles.positions = std::move(positions_);
    out.triangles.source = grid_.source;
    return out;
  }

 private:
  std::int32_t vertex(int row, int column) {
    const Eigen::Vector2d at = grid_.corner(row, column);
    positions_.emplace_back(at.x(), at.y(), 0);
    return static_cast<std::int32_t>(positions_.size()) - 1;
  }

  /// Boxes that end at a row meet boxes that begin there: two vertices for each common part.
  void join_boxes() {
    std::vector<std::vector<std::size_t>> begin(static_cast<std::size_t>(grid_.rows) + 1), end = begin;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      begin[static_cast<std::size_t>(boxes_[i].row)].push_back(i);
      end[static_cast<std::size_t>(boxes_[i].row_end)].push_back(i);
    }
    const auto by_column = [this](std::size_t a, std::size_t b) { return boxes_[a].column < boxes_[b].column; };
    for (std::size_t row = 0; row < begin.size(); ++row) {
      std::vector<std::size_t>&below = end[row], &above = begin[row];
      std::sort(below.begin(), below.end(), by_column);
      std::sort(above.begin(), above.end(), by_column);
      for (auto b = below.begin(), a = above.begin(); b != below.end() && a != above.end();) {
        const int from = std::max(boxes_[*b].column, boxes_[*a].column);
        const int to = std::min(boxes_[*b].column_end, boxes_[*a].column_end);
        if (from < to) {
          for (const int column : {from, to}) {
            const SidePoint point{column, vertex(static_cast<int>(row), column)};
            upper_[*b].push_back(point);
            lower_[*a].push_back(point);
          }
        }
        if (boxes_[*b].column_end < boxes_[*a].column_end)
          ++b;
        else
          ++a;
      }
    }
  }

  /// Adds the corners that no other box shares.
  void close(Side& side, const CellBox& box, int row) {
    if (side.empty() || side.front().column != box.column)
      side.insert(side.begin(), {box.column, vertex(row, box.column)});
    if (side.back().column != box.column_end) side.push_back({box.column_end, vertex(row, box.column_end)});
  }

  /// The strip between the two sides, from left to right; the next triangle is on the side whose next point comes
  /// first.
  static void fill(const Side& lower, const Side& upper, PolygonSoup& out) {
    for (std::size_t i = 0, j = 0; i + 1 < lower.size() || j + 1 < upper.size();) {
      const bool on_lower =
          j + 1 == upper.size() || (i + 1 < lower.size() && lower[i + 1].column <= upper[j + 1].column);
      const std::int32_t next = on_lower ? lower[i + 1].vertex : upper[j + 1].vertex;
      for (const std::int32_t corner : {lower[i].vertex, next, upper[j].vertex}) out.corners.push_back(corner);
      out.polygon_begin.push_back(static_cast<std::int32_t>(out.corners.size()));
      ++(on_lower ? i : j);
    }
  }

  const OccupancyGrid& grid_;
  const std::vector<CellBox>& boxes_;
  std::vector<Side> lower_, upper_;
  std::vector<Eigen::Vector3d> positions_;
};

}  // namespace

FreeMesh free_mesh(const OccupancyGrid& grid, const std::vector<CellBox>& boxes) { return Mesher(grid, boxes).mesh(); }

}  // namespace leastcost
