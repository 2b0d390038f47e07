// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <leastcost/problems/bracket/search/box_bracket.hpp>
#include "problems/bracket/search/bisector.hpp"
#include "problems/bracket/search/descent.hpp"
#include "problems/bracket/search/level_potential.hpp"
#include "problems/bracket/search/rounds.hpp"
#include "problems/bracket/search/tube.hpp"
#include "problems/bracket/smoothed_way.hpp"

namespace leastcost::bracket {

/// Bounds of the least cost between two places of a box: grid after grid, each over what the one before leaves.
template <Medium M, int N = M::kDimension>
class BoxSearch {
 public:
  BoxSearch(M medium, const Box<N>& box, const Vector<N>& source, const Vector<N>& target, double upper,
            const BoxBracketOptions<N>& options)
      : setting_{std::move(medium), Obstacles<N>(options.depth)},
        source_(source),
        target_(target),
        options_(options),
        way_cost_(upper) {
    out_.box = box;
    out_.upper = upper;
  }

  BoxBracket<N> run() {
    try {
      set_level(whole_level(setting_, out_.box, options_.cells, look_));
      search();
    } catch (const Stopped&) {
      out_.stopped = true;
    }
    return std::move(out_);
  }

 private:
  using End = typename M::End;

  void set_level(Level<M> level) { level_ = std::make_shared<const Level<M>>(std::move(level)); }

  /// Grid after grid, until the gap is small enough.
  void search() {
    while (true) {
      count_level();
      const DistanceField<M> from_s = field_of(source_, false), from_t = field_of(target_, true);
      follow_field(from_s);
      if (out_.way_taken) return;
      if (is_part_) bisect(from_s, from_t);
      if (is_done()) return;
      if (!refine(from_s, from_t)) break;
    }
    out_.stopped = !is_done();
  }

  bool is_done() const { return out_.gap() <= options_.tolerance; }

  void count_level() {
    out_.grid = level_->grid.cells;
    out_.cells += static_cast<long>(level_->cells.size());
    ++out_.grids;
  }

  /// The error of the seeds grows with the set around an end, that of the first cells around it falls.
  DistanceField<M> field_of(const Vector<N>& end, bool reversed) {
    const double apart = (source_ - target_).norm();
    const int rings = std::max(3, static_cast<int>(std::lround(0.375 * std::sqrt(apart / level_->grid.h))));
    return distance_field(setting_.medium, *level_, setting_.medium.end(level_->grid, end, rings, reversed), marching_);
  }

  void follow_field(const DistanceField<M>& from_s) {
    bool kept = false;
    for (const Way<N>& way : ways_down(*level_, from_s, target_)) {
      const double cost = setting_.medium.polyline_above(way);
      if (options_.takes_way && cost < out_.upper && options_.takes_way(way)) {
        out_.way = way;
        out_.way_taken = true;
        return;
      }
      kept = keep_cheaper(way, cost) || kept;
    }
    if (!kept || options_.depth) return;  // among obstacles it may be cut short
    const Way<N> wound = out_.way;
    for (const int rounds : {16, 64, 256}) {
      const Way<N> smoothed = smoothed_way(wound, rounds);
      if (!keep_cheaper(smoothed, setting_.medium.polyline_above(smoothed))) return;
    }
  }

  bool keep_cheaper(const Way<N>& way, double cost) {
    if (!(cost < way_cost_)) return false;
    way_cost_ = cost;
    out_.way = way;
    if (!options_.depth) out_.upper = cost;
    return true;
  }

  /// To a bound that is better than what is known, with the potential that proves it: u between the ends.
  void raise_lower(double lower, DistanceBound<M> u, const End& s, const End& t) {
    if (!(lower > out_.lower)) return;
    out_.lower = std::min(lower, out_.upper);
    out_.potential = std::make_shared<const LevelPotential<M>>(level_, std::move(u), s, t);
  }

  /// What a potential proves: its bound.
  double take(const std::vector<double>& u, double ratio, const End& s, const End& t) {
    if (!s.valid || !t.valid || s.touches(t)) return 0;
    const auto at_rim = [&](const End& end, double sign) {
      return Interval(rim_minimum(level_->grid, level_->nodes, end, level_->searched, u, sign, ratio));
    };
    const double lower = (at_rim(s, -1) + at_rim(t, 1)).lo;
    if (lower > out_.lower) raise_lower(lower, {.end = s, .u = u, .ratio = ratio}, s, t);
    return lower;
  }

  /// By the signed distance to the bisector, on a grid that has little behind the ends, where it has shocks.
  void bisect(const DistanceField<M>& from_s, const DistanceField<M>& from_t) {
    constexpr int kRings = 2;
    constexpr int kCorrections = 1, kCorrectionsAtWalls = 3;  // along which fronts creep: there one is too much
    const End s = setting_.medium.end(level_->grid, source_, kRings, false),
              t = setting_.medium.end(level_->grid, target_, kRings, true);
    Front front = front_at_bisector(*level_, from_s.u, from_t.u);
    if (front.seeds.empty()) return;
    std::vector<double> u = march(*level_, front, options_.depth ? kCorrectionsAtWalls : kCorrections, marching_),
                        ratios;
    Rounds<N> rounds(M::kBisectorDeflations, M::kPatience);
    while (true) {
      const double before = out_.gap(), ratio = check(*level_, u, s, t, ratios, look_), lower = take(u, ratio, s, t);
      if (rounds.are_enough(out_, ratio, lower, before) || is_done()) return;
      deflate(*level_, ratios, front);
      u = march(*level_, front, 0, marching_);
    }
  }

  /// A bound of the cost from an end is one of the whole path at the other end.
  void take_at(const DistanceBound<M>& bound, const Vector<N>& x, bool is_from_source) {
    const Grid<N>& grid = level_->grid;
    const Place<N> cell = grid.place_at(x);
    const int node = level_->nodes.find(cell);
    if (!bound.end.valid || bound.end.holds(cell) || node == level_->nodes.none() || !level_->nodes.is_inner(node))
      return;
    std::array<Interval, static_cast<std::size_t>(N)> at;
    for (int k = 0; k < N; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      at[axis] = (Interval(x[k]) - grid.corner[k]) / Interval(grid.h) - (Interval(cell[axis]) - 0.5);
    }
    const Interval u = spline_value<N>(around(level_->nodes, bound.u, node), at);
    const double below = bound.cap < kInfinity ? std::min(u.lo, bound.cap) : u.lo;
    const double lower = (Interval(below) / Interval(bound.ratio) + Interval(bound.offset)).lo;
    if (is_from_source) return raise_lower(lower, bound, bound.end, End());
    DistanceBound<M> falling = bound;  // towards the target
    std::ranges::transform(bound.u, falling.u.begin(), std::negate());
    raise_lower(lower, std::move(falling), End(), bound.end);
  }

  /// The next grid; false where there is none.
  bool refine(const DistanceField<M>& from_s, const DistanceField<M>& from_t) {
    if (!from_s.end.valid || !from_t.end.valid || from_s.end.touches(from_t.end) || !std::isfinite(out_.upper))
      return refine_whole();
    constexpr double kFarther = 1.25;  // than this times the known cost nothing need be told apart
    const double cap = M::kIsotropic ? kInfinity : kFarther * out_.upper;
    const DistanceBound<M> below_s = distance_bound(*level_, from_s, target_, cap, marching_),
                           below_t = distance_bound(*level_, from_t, source_, cap, marching_);
    take_at(below_s, target_, true);
    take_at(below_t, source_, false);
    if (is_done()) return false;
    const auto cells_of = [&](int parts) {
      return reached_cells(setting_.obstacles, *level_, below_s, below_t, out_.upper, parts, look_);
    };
    for (const int parts : parts_of_cells(cells_of)) {
      if (level_->grid.longest() * parts > options_.max_cells) continue;
      const std::vector<Place<N>> cells = cells_of(parts);
      if (cells.empty() || static_cast<double>(cells.size()) > most_cells(parts)) continue;
      set_level(tube_level(setting_, level_->grid, cells, parts, look_));
      is_part_ = true;
      return true;
    }
    return false;
  }

  /// How much smaller the cells of the next grid may be, the best first. In the plane, where many are reached a grid
  /// between narrows what is searched, and among obstacles the gap falls with the size of a cell, elsewhere with its
  /// square.
  template <class CellsOf>
  std::vector<int> parts_of_cells(const CellsOf& cells_of) const {
    constexpr double kMany = 1e6, kNearly = 2;
    constexpr int kMost = 4;
    if (N == 3) return {kMost, 2};
    const bool half = static_cast<double>(cells_of(1).size()) * kMost * kMost > kMany ||
                      (options_.depth && out_.gap() <= kNearly * options_.tolerance);
    return {half ? 2 : kMost};
  }
  /// In space, where more are reached by cells of a quarter than these a grid between narrows what is searched.
  double most_cells(int parts) const {
    constexpr double kFew = 1.2e5;
    return N == 3 && parts == 4 ? std::min(kFew, options_.max_searched) : options_.max_searched;
  }

  /// Where the first grid is too coarse for the ends: a finer one over the whole box.
  bool refine_whole() {
    constexpr double kFiner = N == 2 ? 2 : 1.5;
    constexpr int kFinestWhole = 1024;
    const int cells = static_cast<int>(kFiner * level_->grid.longest());
    if (is_part_ || cells > std::min(kFinestWhole, options_.max_cells)) return false;
    const double nodes = std::pow(kFiner, N) * static_cast<double>(level_->nodes.size());
    if (N == 3 && nodes > options_.max_searched) return false;
    set_level(whole_level(setting_, out_.box, cells, look_));
    return true;
  }

  const Setting<M> setting_;
  const Vector<N> source_, target_;
  const BoxBracketOptions<N>& options_;
  const StopLook look_{options_.stop};
  std::shared_ptr<const Level<M>> level_;
  double way_cost_;       ///< of out_.way, or what it has to be below
  bool is_part_ = false;  ///< of the box, is what the level searches
  FastMarching marching_{look_};
  BoxBracket<N> out_;
};

}  // namespace leastcost::bracket
