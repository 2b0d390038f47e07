// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/cell_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/cells/side_nodes.hpp"
#include "problems/graph/monotone_queue.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kSameSize =
    1e-9;  ///< relative: cells that differ by less are measured as one, and bounds are lowered by it
constexpr double kSameValue = 1e-8;  ///< relative: what changes less is not handed on; check() sees what that does
constexpr double kEps = std::numeric_limits<double>::epsilon();

/// A linear function on a piece of a line, seen from a point: `offset` + `slope` t for t from `low` to `high`, t being
/// measured from the foot of the point, which is `height` away from the line.
struct Seen {
  double offset, slope, low, high, height;

  double distance(double t) const { return std::sqrt(t * t + height * height); }
  double value(double t) const { return offset + slope * t; }
  /// min of value + unit * distance.
  double least_sum(double unit) const {
    if (std::abs(slope) >= unit)
      return std::min(value(low) + unit * distance(low), value(high) + unit * distance(high));
    const double t = std::clamp(-slope * height / std::sqrt((unit - slope) * (unit + slope)), low, high);
    return value(t) + unit * distance(t);
  }
  /// The greatest (value - of + slack) / distance, but for the end `high`, which is the end `low` of the next piece.
  double steepest(double of, double slack) const {
    const double away = distance(low);
    const double most = away > 0 ? (value(low) - of + slack) / away : 0;
    const double up = offset - of + slack;
    if (!(up > 0) || !(height > 0)) return most;
    const double t = slope * height / up * height;
    return t > low && t < high ? std::max(most, std::sqrt(up / height * (up / height) + slope * slope)) : most;
  }
};

/// The pieces of the sides of a cell as its places see them.
class CellShape {
 public:
  CellShape(const SideNodes& nodes, const std::vector<int>& around, const Vector2d& size) : size_(size) {
    for (const int node : around) places_.emplace_back(nodes.place(node) - nodes.place(around.front()));
    count_ = places_.size();
    for (std::size_t piece = 0; piece < count_; ++piece)
      for (const Vector2d& from : places_) views_.push_back(view(piece, from));
  }
  const Vector2d& size() const { return size_; }
  /// Piece k reaches from place k to the next one.
  Seen seen(std::size_t piece, std::size_t from, double first, double second) const {
    return with(views_[piece * count_ + from], first, second);
  }
  Seen seen(std::size_t piece, const Vector2d& from, double first, double second) const {
    return with(view(piece, from), first, second);
  }

 private:
  struct View {
    double low, high, height;
  };
  View view(std::size_t piece, const Vector2d& from) const {
    const Vector2d &a = places_[piece], &b = places_[(piece + 1) % count_];
    const int along = a[1] == b[1] ? 0 : 1;
    const double sign = b[along] > a[along] ? 1 : -1;
    return {sign * (a[along] - from[along]), sign * (b[along] - from[along]), std::abs(a[1 - along] - from[1 - along])};
  }
  static Seen with(const View& v, double first, double second) {
    const double slope = (second - first) / (v.high - v.low);
    return {first - slope * v.low, slope, v.low, v.high, v.height};
  }

  Vector2d size_;
  std::size_t count_ = 0;
  std::vector<Vector2d> places_;
  std::vector<View> views_;
};

class Potential {
 public:
  Potential(const CellMap& map, const Vector2d& source, const Vector2d& target, int points,
            const CellBoundOptions& options)
      : map_(map),
        source_(source),
        target_(target),
        nodes_(map, points),
        options_(options),
        cap_(options.upper * (1 + 1e-9)),
        cheaper_(static_cast<std::size_t>(map.rows()) * static_cast<std::size_t>(map.columns()), 1.0) {}

  CellBound run() {
    constexpr int kRounds = 8;
    constexpr double kIdle = 0.9;
    double last = 0;
    for (int round = 0; round < kRounds && !out_.stopped; ++round) {
      march();
      if (out_.stopped) break;
      const double ratio = check();
      if (out_.stopped) break;
      const double lower = bound(ratio);
      out_.lower = std::max(out_.lower, lower);
      if (!(ratio > 1 + 1e-9) || options_.upper - out_.lower <= options_.tolerance * options_.upper) break;
      if (round > 1 && options_.upper - lower > kIdle * (options_.upper - last)) break;
      last = lower;
    }
    out_.places = nodes_.count();
    return out_;
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  double& cheaper(int row, int column) { return cheaper_[at(row) * at(map_.columns()) + at(column)]; }

  const CellShape& shape_of(int row, int column) {
    nodes_.around(row, column, around_);
    const Vector2d size(map_.line(0, column + 1) - map_.line(0, column), map_.line(1, row + 1) - map_.line(1, row));
    const auto same = [&](const CellShape& shape) { return shape.size().isApprox(size, kSameSize); };
    const auto known = std::find_if(shapes_.begin(), shapes_.end(), same);
    if (known != shapes_.end()) return *known;
    if (shapes_.size() >= 16) shapes_.clear();
    return shapes_.emplace_back(nodes_, around_, size);
  }
  double u(std::size_t k) const { return u_[at(around_[k % around_.size()])]; }

  template <class Visit>
  void each_cell_of(const Vector2d& place, const Visit& visit) {
    const CellRange rows = map_.touched(1, place[1]), columns = map_.touched(0, place[0]);
    for (int row = rows.first; row <= rows.last; ++row)
      for (int column = columns.first; column <= columns.last; ++column)
        if (map_.unit(row, column) < kNone) visit(row, column);
  }

  // The march.

  void offer(int node, double value) {
    value = std::max(value, 0.0);  // what rounding takes off at the source
    if (!(value < u_[at(node)] * (1 - kSameValue)) || value > cap_) return;
    u_[at(node)] = value;
    open_.push(value, node);
  }
  void march() {
    constexpr int kLookEvery = 1 << 12;
    u_.assign(at(nodes_.count()), kNone);
    open_ = {};
    each_cell_of(source_, [&](int row, int column) {
      nodes_.around(row, column, around_);
      const double unit = map_.unit(row, column) * cheaper(row, column);
      for (const int node : around_) offer(node, unit * (nodes_.place(node) - source_).norm());
    });
    for (int steps = 1; !open_.empty(); ++steps) {
      const std::pair<double, int> next = open_.pop();
      const double value = next.first;
      const int node = next.second;
      if (value > u_[at(node)]) continue;
      if (steps % kLookEvery == 0 && (out_.stopped = options_.stop())) return;
      nodes_.each_cell(node, [&](int row, int column) { go_on(node, row, column); });
    }
    for (double& value : u_) value = std::min(value, cap_);
  }
  void go_on(int node, int row, int column) {
    const double unit = map_.unit(row, column) * cheaper(row, column);
    if (!(unit < kNone)) return;
    const CellShape& shape = shape_of(row, column);
    const std::size_t n = around_.size();
    const auto which = static_cast<std::size_t>(std::find(around_.begin(), around_.end(), node) - around_.begin());
    for (const std::size_t piece : {(which + n - 1) % n, which}) {
      const bool both = u(piece) < kNone && u(piece + 1) < kNone;
      for (std::size_t k = 0; k < n; ++k) {
        if (k == which) continue;
        const double here = u_[at(node)];
        const Seen seen = both ? shape.seen(piece, k, u(piece), u(piece + 1)) : shape.seen(piece, k, here, here);
        const double distance = seen.distance(piece == which ? seen.low : seen.high);
        offer(around_[k], both ? seen.least_sum(unit) : here + unit * distance);
      }
    }
  }

  // What it proves.

  /// By what the potential is too steep at most; cells in which it is become cheaper for the next march.
  double check() {
    double most = 1, largest = 0;
    for (const double value : u_)
      if (value < kNone) largest = std::max(largest, value);
    const double slack = 32 * kEps * largest;
    for (int row = 0; row < map_.rows(); ++row) {
      if ((out_.stopped = options_.stop())) return kNone;
      for (int column = 0; column < map_.columns(); ++column) {
        if (!(map_.unit(row, column) < kNone)) continue;
        const double ratio = ratio_in(row, column, slack) / map_.unit(row, column) * (1 + 4 * kSameSize);
        if (ratio > 1 + 1e-12) cheaper(row, column) /= ratio;
        most = std::max(most, ratio);
      }
    }
    return most;
  }
  double ratio_in(int row, int column, double slack) {
    const CellShape& shape = shape_of(row, column);
    const std::size_t n = around_.size();
    double most = 0;
    bool flat = true;  // as where nothing is reached
    for (std::size_t k = 1; k < n && flat; ++k) flat = u(k) == u(0);
    if (flat) return 0;
    for (std::size_t piece = 0; piece < n; ++piece)
      for (std::size_t k = 0; k < n; ++k) {
        const double here = u(k), first = u(piece), second = u(piece + 1);
        most = std::max({most, shape.seen(piece, k, first, second).steepest(here, slack),
                         shape.seen(piece, k, -first, -second).steepest(-here, slack)});
      }
    return most;
  }
  /// What the potential, made flatter by `ratio`, rises from the source to the target at least.
  double bound(double ratio) {
    double begin = -kNone, end = kNone, apart = 0;
    const auto measure = [&](int row, int column) {
      const double sides = map_.line(0, column + 1) - map_.line(0, column) + map_.line(1, row + 1) - map_.line(1, row);
      apart = std::max(apart, 8 * kSameSize * map_.unit(row, column) * sides);
    };
    each_cell_of(source_, measure);
    each_cell_of(target_, measure);
    each_cell_of(source_,
                 [&](int row, int column) { begin = std::max(begin, -least_at(row, column, source_, -ratio)); });
    each_cell_of(target_, [&](int row, int column) { end = std::min(end, least_at(row, column, target_, ratio)); });
    double lower = (end - begin) * (1 - 64 * kEps) - 64 * kEps * (std::abs(end) + std::abs(begin)) - apart;
    if (const auto leg = map_.leg(source_, target_)) lower = std::min(lower, leg->cost * (1 - 8 * kEps));
    return std::max(0.0, lower);
  }
  /// min over the sides of u / ratio + n |q - place|.
  double least_at(int row, int column, const Vector2d& place, double ratio) {
    const CellShape& shape = shape_of(row, column);
    const Vector2d from = place - nodes_.place(around_.front());
    double least = kNone;
    for (std::size_t piece = 0; piece < around_.size(); ++piece)
      least = std::min(
          least, shape.seen(piece, from, u(piece) / ratio, u(piece + 1) / ratio).least_sum(map_.unit(row, column)));
    return least;
  }

  const CellMap& map_;
  const Vector2d source_, target_;
  const SideNodes nodes_;
  const CellBoundOptions& options_;
  const double cap_;
  std::vector<double> cheaper_;  ///< per cell: what its cost is multiplied by in the march
  std::vector<double> u_;
  std::vector<int> around_;
  std::vector<CellShape> shapes_;
  MonotoneQueue<int> open_;
  CellBound out_;
};

}  // namespace

CellBound bound_in_cells(const CellMap& map, const Vector2d& source, const Vector2d& target,
                         const CellBoundOptions& options) {
  constexpr int kLast = 31;
  CellBound best;
  const int first = SideNodes::count_for(map, 3) > options.most_places ? 1 : 3;
  for (int points = first; points <= kLast; points = 2 * points + 1) {
    if (SideNodes::count_for(map, points) > options.most_places) break;
    const CellBound found = Potential(map, source, target, points, options).run();
    best.places += found.places;
    best.stopped = found.stopped;
    if (found.lower > best.lower) best.lower = found.lower, best.side_points = points;
    if (found.stopped || options.upper - best.lower <= options.tolerance * options.upper) break;
  }
  best.lower = std::min(best.lower, options.upper);
  return best;
}

}  // namespace leastcost
