// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/space/space_bracket.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/bracket/smoothed_way.hpp"
#include "problems/bracket/space/space_bisector.hpp"
#include "problems/bracket/space/space_descent.hpp"
#include "problems/bracket/space/space_level.hpp"
#include "problems/bracket/space/space_tube.hpp"
#include "problems/bracket/space/spline_place.hpp"

namespace leastcost {
namespace {

using namespace bracket;
using Eigen::Vector3d;

/// A spline on the nodes of a level.
class LevelPotential final : public SpacePotential {
 public:
  LevelPotential(std::shared_ptr<const SpaceLevel> level, std::vector<double> u, double ratio, const EndBall& s,
                 const EndBall& t)
      : level_(std::move(level)), u_(std::move(u)), ratio_(ratio), s_(s), t_(t) {}

  bool is_checked(const Vector3d& x) const override {
    const Place cell = level_->grid.place_at(x);
    return level_->searched[static_cast<std::size_t>(level_->nodes.find(cell))] != 0 && !s_.holds(cell) &&
           !t_.holds(cell);
  }
  double value(const Vector3d& x) const override {
    const SplinePlace p(level_->grid, level_->nodes, u_, x);
    return p.known ? spline_value<double>(p.coefficients, {p.at[0], p.at[1], p.at[2]})
                   : std::numeric_limits<double>::quiet_NaN();
  }
  Vector3d gradient(const Vector3d& x) const override { return spline_slope(level_->grid, level_->nodes, u_, x); }
  double ratio() const override { return ratio_; }

 private:
  std::shared_ptr<const SpaceLevel> level_;
  std::vector<double> u_;
  double ratio_;
  EndBall s_, t_;
};

class SpaceSearch {
 public:
  SpaceSearch(const SpaceDensity& density, const Eigen::AlignedBox3d& box, const Vector3d& source,
              const Vector3d& target, double upper, const SpaceBracketOptions& options)
      : medium_{density, options.depth}, source_(source), target_(target), options_(options), way_cost_(upper) {
    out_.box = box;
    out_.upper = upper;
  }

  SpaceBracket run() {
    try {
      set_level(whole_space_level(medium_, out_.box, options_.cells, look_));
      search();
    } catch (const Stopped&) {
      out_.stopped = true;
    }
    return std::move(out_);
  }

 private:
  void set_level(SpaceLevel level) { level_ = std::make_shared<const SpaceLevel>(std::move(level)); }

  /// Grid after grid, until the gap is small enough.
  void search() {
    while (true) {
      count_level();
      const SpaceDistance from_s = field_of(source_), from_t = field_of(target_);
      follow_field(from_s);
      if (out_.way_taken) return;
      if (is_part_) bisect(from_s, from_t);
      if (out_.gap() <= options_.tolerance) return;
      if (!refine(from_s, from_t)) break;
    }
    out_.stopped = out_.gap() > options_.tolerance;
  }

  void count_level() {
    out_.grid = level_->grid.cells;
    out_.cells += static_cast<long>(level_->cells.size());
    ++out_.grids;
  }

  /// The error of the seeds grows with the ball around an end, that of the first cells around it falls.
  SpaceDistance field_of(const Vector3d& end) {
    const double apart = (source_ - target_).norm();
    const int rings = std::max(3, static_cast<int>(std::lround(0.375 * std::sqrt(apart / level_->grid.h))));
    return distance_field(medium_, *level_, end_ball(medium_.density, level_->grid, end, rings), marching_);
  }

  void follow_field(const SpaceDistance& from_s) {
    bool kept = false;
    for (const Eigen::Matrix3Xd& way : ways_down(*level_, from_s, target_)) {
      const double cost = polyline_cost_above(medium_.density, way);
      if (options_.takes_way && cost < out_.upper && options_.takes_way(way)) {
        out_.way = way;
        out_.way_taken = true;
        return;
      }
      kept = keep_cheaper(way, cost) || kept;
    }
    if (!kept || options_.depth) return;  // among obstacles it may be cut short
    const Eigen::Matrix3Xd wound = out_.way;
    for (const int rounds : {16, 64, 256}) {
      const Eigen::Matrix3Xd smoothed = smoothed_way(wound, rounds);
      if (!keep_cheaper(smoothed, polyline_cost_above(medium_.density, smoothed))) return;
    }
  }

  bool keep_cheaper(const Eigen::Matrix3Xd& way, double cost) {
    if (!(cost < way_cost_)) return false;
    way_cost_ = cost;
    out_.way = way;
    if (!options_.depth) out_.upper = cost;
    return true;
  }

  /// To a bound that is better than what is known, with the potential that proves it.
  void raise_lower(double lower, const std::vector<double>& u, double ratio, const EndBall& s, const EndBall& t) {
    if (!(lower > out_.lower)) return;
    out_.lower = std::min(lower, out_.upper);
    out_.potential = std::make_shared<const LevelPotential>(level_, u, ratio, s, t);
  }

  /// What a potential proves.
  void take(const std::vector<double>& u, double ratio, const EndBall& s, const EndBall& t) {
    if (!s.valid || !t.valid || s.touches(t)) return;
    const double begin = rim_minimum(level_->grid, level_->nodes, s, level_->searched, u, -1, ratio),
                 end = rim_minimum(level_->grid, level_->nodes, t, level_->searched, u, 1, ratio);
    raise_lower((Interval(begin) + Interval(end)).lo, u, ratio, s, t);
  }

  /// By the signed distance to the bisector, on a grid that has little behind the ends, where it has shocks.
  void bisect(const SpaceDistance& from_s, const SpaceDistance& from_t) {
    constexpr double kWorthWhile = 0.97, kFallen = 0.7, kSmall = 0.02;
    constexpr int kRings = 2, kDeflations = 8;
    constexpr int kCorrections = 1, kCorrectionsAtWalls = 3;  // as in the plane
    const EndBall s = end_ball(medium_.density, level_->grid, source_, kRings),
                  t = end_ball(medium_.density, level_->grid, target_, kRings);
    SpaceFront front = front_at_bisector(*level_, from_s.u, from_t.u);
    if (front.seeds.empty()) return;
    std::vector<double> u = march(*level_, front, options_.depth ? kCorrectionsAtWalls : kCorrections, marching_),
                        ratios;
    double excess = kInfinity;
    for (int round = 0;; ++round) {
      const double gap = out_.gap(), excess_before = excess, ratio = check(*level_, u, s, t, ratios, look_);
      take(u, ratio, s, t);
      excess = ratio - 1;
      const bool stalls = round > 1 && out_.gap() > kWorthWhile * gap && !(excess < kFallen * excess_before);
      if (excess <= kSmall * out_.gap() || round == kDeflations || stalls || out_.gap() <= options_.tolerance) return;
      deflate(*level_, ratios, front);
      u = march(*level_, front, 0, marching_);
    }
  }

  /// A bound of the cost from an end is one of the whole path at the other end.
  void take_at(const SpaceDistanceBound& bound, const Vector3d& x, bool is_from_source) {
    const Place cell = level_->grid.place_at(x);
    const int node = level_->nodes.find(cell);
    if (!bound.ball.valid || bound.ball.holds(cell) || node == level_->nodes.none() || !level_->nodes.is_inner(node))
      return;
    std::array<Interval, 3> at;
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = (Interval(x[static_cast<int>(k)]) - level_->grid.corner[static_cast<int>(k)]) / Interval(level_->grid.h) -
              (Interval(cell[k]) - 0.5);
    const Interval u = spline_value<Interval>(around(level_->nodes, bound.u, node), at);
    const double lower = (u / Interval(bound.ratio) + Interval(bound.offset)).lo;
    if (is_from_source) return raise_lower(lower, bound.u, bound.ratio, bound.ball, EndBall());
    std::vector<double> falling(bound.u.size());  // towards the target
    std::ranges::transform(bound.u, falling.begin(), std::negate());
    raise_lower(lower, falling, bound.ratio, EndBall(), bound.ball);
  }

  /// The next grid; false where there is none.
  bool refine(const SpaceDistance& from_s, const SpaceDistance& from_t) {
    if (!from_s.ball.valid || !from_t.ball.valid || from_s.ball.touches(from_t.ball) || !std::isfinite(out_.upper))
      return refine_whole();
    const SpaceDistanceBound below_s = distance_bound(*level_, from_s, target_, marching_),
                             below_t = distance_bound(*level_, from_t, source_, marching_);
    take_at(below_s, target_, true);
    take_at(below_t, source_, false);
    if (out_.gap() <= options_.tolerance) return false;
    constexpr double kFew = 1.2e5;  // cells: where there are more, a grid between narrows what is searched
    for (const int parts : {4, 2}) {
      if (level_->grid.longest() * parts > options_.max_cells) continue;
      const std::vector<Place> cells = reached_cells(medium_, *level_, below_s, below_t, out_.upper, parts, look_);
      const auto count = static_cast<double>(cells.size());
      if (cells.empty() || count > (parts == 4 ? std::min(kFew, options_.max_searched) : options_.max_searched))
        continue;
      set_level(tube_level(medium_, level_->grid, cells, parts, look_));
      is_part_ = true;
      return true;
    }
    return false;
  }

  /// Where the first grid is too coarse for the ends: a finer one over the whole box.
  bool refine_whole() {
    constexpr double kFiner = 1.5;
    const int cells = static_cast<int>(kFiner * level_->grid.longest());
    const double nodes = std::pow(kFiner, 3) * static_cast<double>(level_->nodes.size());
    if (is_part_ || cells > options_.max_cells || nodes > options_.max_searched) return false;
    set_level(whole_space_level(medium_, out_.box, cells, look_));
    return true;
  }

  const SpaceMedium medium_;
  const Vector3d source_, target_;
  const SpaceBracketOptions& options_;
  const StopLook look_{options_.stop};
  std::shared_ptr<const SpaceLevel> level_;
  double way_cost_;       ///< of out_.way, or what it has to be below
  bool is_part_ = false;  ///< of the box, is what the level searches
  SpaceMarching marching_{look_};
  SpaceBracket out_;
};

}  // namespace

SpaceBracket bracket_least_cost(const SpaceDensity& density, const Eigen::AlignedBox3d& box, const Vector3d& source,
                                const Vector3d& target, double upper, const SpaceBracketOptions& options) {
  if (!(box.sizes().minCoeff() > 0) || !box.sizes().allFinite())
    throw InputError("a bracket needs a box with finite sides of some length");
  if (!box.contains(source) || !box.contains(target))
    throw InputError("both ends have to lie in the box of the bracket");
  return SpaceSearch(density, box, source, target, upper, options).run();
}

}  // namespace leastcost
