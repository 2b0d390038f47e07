// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/plane/bracket.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/numbers/dual.hpp>
#include "problems/bracket/plane/bisector.hpp"
#include "problems/bracket/plane/descent.hpp"
#include "problems/bracket/plane/distance_bound.hpp"
#include "problems/bracket/plane/tube.hpp"
#include "problems/bracket/smoothed_way.hpp"

namespace leastcost {
namespace {

using namespace bracket;
using Eigen::Vector2d;

constexpr int kBisectorRings = 2;
constexpr int kBisectorDeflations = 6, kSampledDeflations = 12;
constexpr int kCorrections = 1, kCorrectionsAtWalls = 3;  ///< along which fronts creep: there one is too much

class Search {
 public:
  Search(const Medium& medium, const Eigen::AlignedBox2d& box, const Vector2d& source, const Vector2d& target,
         double upper, const BracketOptions& options)
      : medium_(medium), source_(source), target_(target), options_(options), way_cost_(upper) {
    out_.box = box;
    out_.upper = upper;
  }

  Bracket run() {
    try {
      level_ = whole_level(medium_, out_.box, options_.cells, look_);
      search();
    } catch (const Stopped&) {
      out_.stopped = true;
    }
    return std::move(out_);
  }

 private:
  /// Grid after grid, until the gap is small enough.
  void search() {
    while (true) {
      count_level();
      const DistanceField from_s = field_of(source_, false), from_t = field_of(target_, true);
      follow_field(from_s);
      if (out_.way_taken) return;
      if (is_part_) bisect(from_s, from_t);
      if (out_.gap() <= options_.tolerance) return;
      if (!refine(from_s, from_t)) break;
    }
    out_.stopped = true;
  }

  void count_level() {
    out_.grid = {level_.grid.nx, level_.grid.ny};
    out_.cells += static_cast<long>(level_.cells.size());
    ++out_.grids;
  }

  /// The error of the seeds grows with the square around an end, that of the first cells around it falls.
  DistanceField field_of(const Vector2d& end, bool reversed) {
    const double apart = (source_ - target_).norm();
    const int rings = std::max(3, static_cast<int>(std::lround(0.375 * std::sqrt(apart / level_.grid.h))));
    return distance_field(medium_, level_, medium_.end_region(level_.grid, end, rings, reversed), marching_);
  }

  void follow_field(const DistanceField& from_s) {
    bool kept = false;
    for (const Eigen::Matrix2Xd& way : ways_down(level_, from_s, target_)) {
      const double cost = medium_.polyline_above(way);
      if (options_.takes_way && cost < out_.upper && options_.takes_way(way)) {
        out_.way = way;
        out_.way_taken = true;
        return;
      }
      kept = keep_cheaper(way, cost) || kept;
    }
    if (!kept || options_.depth) return;  // among obstacles it may be cut short
    const Eigen::Matrix2Xd wound = out_.way;
    for (const int rounds : {16, 64, 256}) {
      const Eigen::Matrix2Xd smoothed = smoothed_way(wound, rounds);
      if (!keep_cheaper(smoothed, medium_.polyline_above(smoothed))) return;
    }
  }

  bool keep_cheaper(const Eigen::Matrix2Xd& way, double cost) {
    if (!(cost < way_cost_)) return false;
    way_cost_ = cost;
    out_.way = way;
    if (!options_.depth) out_.upper = cost;
    return true;
  }

  /// To a bound that is better than what is known, with the potential that proves it.
  void raise_lower(double lower, const std::vector<double>& u, double ratio, double cap, int source_rings,
                   int target_rings) {
    if (!(lower > out_.lower)) return;
    out_.lower = std::min(lower, out_.upper);
    const CellGrid& grid = level_.grid;
    auto potential = std::make_shared<BracketPotential>();
    *potential = {{grid.x0, grid.y0}, grid.h,       grid.nx, grid.ny, u, level_.searched, ratio, cap,
                  source_rings,       target_rings, source_, target_};
    out_.potential = std::move(potential);
  }

  /// What a potential proves: its bound.
  double take(const std::vector<double>& u, double ratio, const EndRegion& s, const EndRegion& t) {
    if (!s.valid || !t.valid || s.touches(t)) return 0;
    const CellGrid& grid = level_.grid;
    const double begin = rim_minimum(grid, s, level_.searched, u, -1, ratio),
                 end = rim_minimum(grid, t, level_.searched, u, 1, ratio);
    const double lower = (Interval(begin) + Interval(end)).lo;
    raise_lower(lower, u, ratio, kInfinity, s.k, t.k);
    return lower;
  }

  /// By the signed distance to the bisector, on a grid that has little behind the ends, where it has shocks.
  void bisect(const DistanceField& from_s, const DistanceField& from_t) {
    constexpr double kWorthWhile = 0.97;
    const EndRegion s = medium_.end_region(level_.grid, source_, kBisectorRings, false),
                    t = medium_.end_region(level_.grid, target_, kBisectorRings, true);
    Front front = front_at_bisector(level_, from_s.u, from_t.u);
    if (front.seeds.empty()) return;
    std::vector<double> u = march(level_, front, options_.depth ? kCorrectionsAtWalls : kCorrections, marching_),
                        ratios;
    const int most = medium_.sampled != nullptr ? kSampledDeflations : kBisectorDeflations,
              patience = medium_.sampled != nullptr ? 3 : 1;
    int idle = 0;     // rounds that brought little
    double best = 0;  // on this grid
    for (int round = 0;; ++round) {
      const double ratio = check(level_, u, s, t, ratios), lower = take(u, ratio, s, t);
      idle = round > 1 && out_.upper - lower > kWorthWhile * (out_.upper - best) ? idle + 1 : 0;
      best = std::max(best, lower);
      if (!(ratio > 1) || round == most || idle == patience || out_.gap() <= options_.tolerance) return;
      deflate(level_, ratios, front);
      u = march(level_, front, 0, marching_);
    }
  }

  /// A bound of the cost from an end is one of the whole path at the other end.
  void take_at(const DistanceBound& bound, const Vector2d& x) {
    const CellGrid& grid = level_.grid;
    const int i = grid.column_at(x[0]), j = grid.row_at(x[1]);
    if (!bound.region.valid || bound.region.holds(i, j)) return;
    const Interval h(grid.h), a = (Interval(x[0]) - grid.x0) / h - (Interval(i) - 0.5),
                              b = (Interval(x[1]) - grid.y0) / h - (Interval(j) - 0.5);
    const Interval u = spline_value<Interval>(bound.u, grid.stride(), static_cast<std::size_t>(grid.id(i, j)), a, b);
    const double lower = (Interval(std::min(u.lo, bound.cap)) / Interval(bound.ratio) + Interval(bound.offset)).lo;
    if (!bound.region.reversed) return raise_lower(lower, bound.u, bound.ratio, bound.cap, bound.region.k, -1);
    std::vector<double> falling(bound.u.size());  // towards the target
    std::ranges::transform(bound.u, falling.begin(), std::negate());
    raise_lower(lower, falling, bound.ratio, bound.cap, -1, bound.region.k);
  }

  /// The next grid; false where there is none.
  bool refine(const DistanceField& from_s, const DistanceField& from_t) {
    if (!from_s.region.valid || !from_t.region.valid || from_s.region.touches(from_t.region) ||
        !std::isfinite(out_.upper))
      return refine_whole();
    constexpr double kFarther = 1.25;  // than this times the known cost nothing need be told apart
    const double cap = medium_.density == nullptr ? kFarther * out_.upper : kInfinity;
    const DistanceBound below_s = distance_bound(level_, from_s, cap, marching_),
                        below_t = distance_bound(level_, from_t, cap, marching_);
    take_at(below_s, target_);
    take_at(below_t, source_);
    if (out_.gap() <= options_.tolerance) return false;
    const int parts = parts_of_cells(below_s, below_t);
    if (parts == 0) return false;
    level_ = tube_level(medium_, level_, below_s, below_t, out_.upper, parts, look_);
    is_part_ = true;
    return !level_.cells.empty() && static_cast<double>(level_.cells.size()) <= options_.max_searched;
  }

  /// How much smaller the cells of the next grid are; 0: there is none. Where many are reached a grid between narrows
  /// what is searched, and among obstacles the gap falls with the size of a cell, elsewhere with its square.
  int parts_of_cells(const DistanceBound& below_s, const DistanceBound& below_t) const {
    constexpr double kMany = 1e6, kNearly = 2;
    constexpr int kMost = 4;
    const auto reached = static_cast<double>(reached_cells(level_, below_s, below_t, out_.upper));
    const bool half = reached * kMost * kMost > kMany || (options_.depth && out_.gap() <= kNearly * options_.tolerance);
    const int parts = half ? 2 : kMost;
    return std::max(level_.grid.nx, level_.grid.ny) * parts > options_.max_cells ? 0 : parts;
  }

  /// Where the first grid is too coarse for the ends: a finer one over the whole box.
  bool refine_whole() {
    constexpr int kFinestWhole = 1024;
    const int cells = 2 * std::max(level_.grid.nx, level_.grid.ny);
    if (is_part_ || cells > std::min(kFinestWhole, options_.max_cells)) return false;
    level_ = whole_level(medium_, out_.box, cells, look_);
    return true;
  }

  const Medium medium_;
  const Vector2d source_, target_;
  const BracketOptions& options_;
  const StopLook look_{options_.stop};
  Level level_;
  double way_cost_;       ///< of out_.way, or what it has to be below
  bool is_part_ = false;  ///< of the box, is what the level searches
  FastMarching marching_{look_};
  Bracket out_;
};

/// The cell of a place, from 1 on, and where in it.
struct Located {
  int i, j;
  double a, b;
};
Located locate(const BracketPotential& p, const Vector2d& x) {
  const Vector2d at = (x - p.corner) / p.side;
  const int i = std::clamp(static_cast<int>(std::floor(at[0])) + 1, 1, p.nx),
            j = std::clamp(static_cast<int>(std::floor(at[1])) + 1, 1, p.ny);
  return {i, j, at[0] - i + 0.5, at[1] - j + 0.5};
}

std::size_t node_of(const BracketPotential& p, const Located& at) {
  return static_cast<std::size_t>(at.j * (p.nx + 2) + at.i);
}

bool in_square(const BracketPotential& p, const Located& at, const Vector2d& end, int rings) {
  const Located e = locate(p, end);
  return std::abs(at.i - e.i) <= rings && std::abs(at.j - e.j) <= rings;
}

}  // namespace

bool BracketPotential::is_checked(const Vector2d& x) const {
  const Located at = locate(*this, x);
  return searched[node_of(*this, at)] != 0 && !in_square(*this, at, source, source_rings) &&
         !in_square(*this, at, target, target_rings) && std::abs(value(x)) < cap;
}

double BracketPotential::value(const Vector2d& x) const {
  const Located at = locate(*this, x);
  return spline_value<double>(coefficients, nx + 2, node_of(*this, at), at.a, at.b);
}

Vector2d BracketPotential::gradient(const Vector2d& x) const {
  const Located at = locate(*this, x);
  using Slope = Dual<double, 2>;
  Slope a(at.a), b(at.b);
  a.d[0] = b.d[1] = 1;
  const Slope v = spline_value<Slope>(coefficients, nx + 2, node_of(*this, at), a, b);
  return Vector2d(v.d[0], v.d[1]) / side;
}

namespace {

Bracket bracket_in(const Medium& medium, const Eigen::AlignedBox2d& box, const Vector2d& source, const Vector2d& target,
                   double upper, const BracketOptions& options) {
  if (!(box.sizes().minCoeff() > 0) || !box.sizes().allFinite())
    throw InputError("a bracket needs a box with finite sides of some length");
  if (!box.contains(source) || !box.contains(target))
    throw InputError("both ends have to lie in the box of the bracket");
  return Search(medium, box, source, target, upper, options).run();
}

}  // namespace

Bracket bracket_least_cost(const CostDensity& density, const Eigen::AlignedBox2d& box, const Vector2d& source,
                           const Vector2d& target, double upper, const BracketOptions& options) {
  return bracket_in({density, options.depth}, box, source, target, upper, options);
}

Bracket bracket_least_cost(const CostDual& dual, const Eigen::AlignedBox2d& box, const Vector2d& source,
                           const Vector2d& target, double upper, const BracketOptions& options) {
  return bracket_in({dual, options.depth}, box, source, target, upper, options);
}

Bracket bracket_least_cost(const CoordinateCost& cost, const Eigen::AlignedBox2d& box, const Vector2d& source,
                           const Vector2d& target, double upper, const BracketOptions& options) {
  return bracket_in({cost, box, options.depth}, box, source, target, upper, options);
}

}  // namespace leastcost
