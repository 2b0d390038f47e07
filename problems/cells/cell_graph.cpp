// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/cell_graph.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "problems/cells/side_nodes.hpp"
#include "problems/graph/monotone_queue.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr int kSource = -1;
constexpr int kLookEvery = 1 << 14;
constexpr double kEqualCells = 1e-9;  ///< what the rounding of large coordinates makes of equal cells

/// Distances between the nodes around a cell, of the last size that was asked for.
class SideDistances {
 public:
  explicit SideDistances(const SideNodes& nodes) : nodes_(nodes), count_(static_cast<std::size_t>(nodes.around())) {}
  const double* from(std::size_t which, const std::vector<int>& around, const Vector2d& size) {
    if (!size.isApprox(size_, kEqualCells)) measure(around, size);
    return &distances_[which * count_];
  }

 private:
  void measure(const std::vector<int>& around, const Vector2d& size) {
    size_ = size;
    distances_.clear();
    for (const int a : around)
      for (const int b : around) distances_.push_back((nodes_.place(a) - nodes_.place(b)).norm());
  }
  const SideNodes& nodes_;
  std::size_t count_;
  Vector2d size_ = Vector2d::Zero();
  std::vector<double> distances_;
};

class Route {
 public:
  Route(const CellMap& map, const Vector2d& source, const Vector2d& target, int points)
      : map_(map),
        source_(source),
        target_(target),
        nodes_(map, points),
        distances_(nodes_),
        least_(map.least_unit()),
        target_rows_(map.touched(1, target[1])),
        target_columns_(map.touched(0, target[0])),
        reached_(static_cast<std::size_t>(nodes_.count()), kUnreached),
        before_(static_cast<std::size_t>(nodes_.count()), kSource),
        by_(before_),
        done_(before_.size(), false) {}

  CellPath find(const std::function<void()>& look) {
    if (const auto leg = map_.leg(source_, target_)) best_ = leg->cost;
    each_cell_of(source_, [&](int row, int column) { begin(row, column); });
    for (int steps = 1; !open_.empty(); ++steps) {
      const std::pair<double, int> next = open_.pop();
      if (!(next.first < best_)) break;
      const int node = next.second;
      if (done_[at(node)]) continue;
      done_[at(node)] = true;
      if (look && steps % kLookEvery == 0) look();
      nodes_.each_cell(node, [&](int row, int column) { go_on(node, row, column); });
    }
    return way_back();
  }

 private:
  static std::size_t at(int node) { return static_cast<std::size_t>(node); }
  double ahead(int node) const { return least_ * (nodes_.place(node) - target_).norm() * (1 - 1e-12); }

  template <class Visit>
  void each_cell_of(const Vector2d& place, const Visit& visit) const {
    const CellRange rows = map_.touched(1, place[1]), columns = map_.touched(0, place[0]);
    for (int row = rows.first; row <= rows.last; ++row)
      for (int column = columns.first; column <= columns.last; ++column)
        if (map_.unit(row, column) < kUnreached) visit(row, column);
  }
  int number(int row, int column) const { return row * map_.columns() + column; }
  void reach(int node, double cost, int from, int cell) {
    if (!(cost < reached_[at(node)]) || done_[at(node)]) return;
    reached_[at(node)] = cost;
    before_[at(node)] = from;
    by_[at(node)] = cell;
    open_.push(cost + ahead(node), node);
  }
  void begin(int row, int column) {
    nodes_.around(row, column, around_);
    for (const int node : around_)
      reach(node, map_.unit(row, column) * (nodes_.place(node) - source_).norm(), kSource, number(row, column));
  }
  void go_on(int node, int row, int column) {
    const double unit = map_.unit(row, column);
    if (!(unit < kUnreached)) return;
    const bool came_by_it = by_[at(node)] == number(row, column);  // from where all of its places are nearer
    if (came_by_it && !touches_target(row, column)) return;
    nodes_.around(row, column, around_);
    const auto which = static_cast<std::size_t>(std::find(around_.begin(), around_.end(), node) - around_.begin());
    const Vector2d size(map_.line(0, column + 1) - map_.line(0, column), map_.line(1, row + 1) - map_.line(1, row));
    const double* distance = distances_.from(which, around_, size);
    const double here = reached_[at(node)];
    for (std::size_t k = 0; k < around_.size(); ++k)
      reach(around_[k], here + unit * distance[k], node, number(row, column));
    if (!touches_target(row, column)) return;
    const double whole = here + unit * (nodes_.place(node) - target_).norm();
    if (whole < best_) best_ = whole, last_ = node;
  }
  bool touches_target(int row, int column) const {
    return row >= target_rows_.first && row <= target_rows_.last && column >= target_columns_.first &&
           column <= target_columns_.last;
  }
  CellPath way_back() const {
    if (best_ == kUnreached) return {};
    CellPath path = {target_};
    for (int node = last_; node != kSource; node = before_[at(node)])
      if (nodes_.place(node) != path.back()) path.push_back(nodes_.place(node));
    if (source_ != path.back() || path.size() < 2) path.push_back(source_);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const CellMap& map_;
  const Vector2d source_, target_;
  const SideNodes nodes_;
  SideDistances distances_;
  const double least_;
  const CellRange target_rows_, target_columns_;
  std::vector<double> reached_;
  std::vector<int> before_;
  std::vector<int> by_;  ///< the cell of the last move
  std::vector<bool> done_;
  std::vector<int> around_;
  MonotoneQueue<int> open_;
  double best_ = kUnreached;
  int last_ = kSource;
};

}  // namespace

CellPath least_cell_path(const CellMap& map, const Vector2d& source, const Vector2d& target, int points,
                         const std::function<void()>& look) {
  return Route(map, source, target, points).find(look);
}

}  // namespace leastcost
