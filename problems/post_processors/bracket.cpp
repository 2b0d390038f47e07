// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/bracket.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/checks_moves.hpp>
#include <leastcost/framework/clearance.hpp>
#include <leastcost/framework/has_box.hpp>
#include <leastcost/problems/bracket/bracket.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include "problems/bracket/potential_samples.hpp"
#include "problems/bracket/smooth_polyline.hpp"
#include "problems/post_processors/search_time.hpp"

namespace leastcost {

/// The bracket of the problem that was asked for last.
struct KeptBracket {
  std::mutex lock;
  std::shared_ptr<const SegmentCost> cost;  // kept alive, hence its address is its own
  std::shared_ptr<const ConstraintManifold> domain;
  const Walls* walls = nullptr;  // of the domain; margins fitted to a chain make another domain of the same walls
  Eigen::AlignedBox2d box;
  Bracket bracket;
  Eigen::Vector2d source = Eigen::Vector2d::Zero(), target = Eigen::Vector2d::Zero();
  double seconds = 0;
  double left = 0;  ///< cost of the path from which another way was offered; 0: none was
};

namespace {

using Eigen::Vector2d;

/// A way down the field cuts in at obstacles, and so costs less than a path by so little even where it leads elsewhere.
constexpr double kClearlyLess = 0.98;

/// The box that all paths stay in; empty where there is none.
Eigen::AlignedBox2d box_of(const ConstraintManifold& domain) {
  const auto* box = find_ability<HasBox>(domain);
  if (box == nullptr || !box->box_lower().allFinite() || !box->box_upper().allFinite()) return {};
  return {Vector2d(box->box_lower()), Vector2d(box->box_upper())};
}

/// Obstacles in the plane itself, whose gaps are distances; null: there are none.
const Walls* walls_in_plane(const ConstraintManifold& domain) {
  const auto* among = find_ability<HasWalls>(domain);
  if (among == nullptr || among->walls().dimension() != 2 || !among->walls().rounds(box_of(domain))) return nullptr;
  return &among->walls();
}

/// What is known of a cost in cells: one of both, or neither.
struct CostInCells {
  std::shared_ptr<const CostDensity> density;
  std::shared_ptr<const CostDual> dual;

  explicit operator bool() const { return density != nullptr || dual != nullptr; }
  double above(const Eigen::Matrix2Xd& x) const {
    return dual != nullptr ? polyline_cost_above(*dual, x) : polyline_cost_above(*density, x);
  }
  bool is_known_at(const Vector2d& x) const {
    if (dual == nullptr) return density->enclose_density({x, x}).is_finite();
    const DualNorm<CostDual::Jet> norm = dual->enclose_cell({x, x});
    const auto known = [](const CostDual::Jet& f) {
      return f.value().is_finite() && f.d(0, 0).is_finite() && f.d(0, 1).is_finite() && f.d(1, 1).is_finite();
    };
    return known(norm.xx) && known(norm.xy) && known(norm.yy) && known(norm.wx) && known(norm.wy);
  }
};

/// Whether the dual norm is the same in all directions at some places, as far as rounding lets it.
bool looks_isotropic(const CostDual& dual, const Eigen::AlignedBox2d& box) {
  constexpr double kRounding = 1e-9;
  constexpr int kPlaces = 5;
  for (int k = 0; k < kPlaces; ++k) {
    const Vector2d part(0.1 + 0.19 * k, std::fmod(0.07 + 0.41 * k, 1.0)),
        x = box.min() + box.sizes().cwiseProduct(part);
    const DualNorm<double> norm = dual.dual(box.center() + 0.9 * (x - box.center()));
    if (!std::isfinite(norm.xx)) continue;
    const double size = kRounding * (norm.xx + norm.yy);
    if (std::abs(norm.xx - norm.yy) > size || std::abs(norm.xy) > size || norm.wx != 0 || norm.wy != 0) return false;
  }
  return true;
}

/// Both bounds hold for every metric; that of a density is narrow where the metric is the same in all directions.
CostInCells in_cells(const Problem& problem) {
  CostInCells cost{density_of(problem.cost), dual_of(problem.cost)};
  if (cost.density != nullptr && cost.dual != nullptr) {
    const Vector2d source = problem.source.u;
    if (looks_isotropic(*cost.dual, box_of(*problem.manifold)) &&
        cost.density->enclose_density({source, source}).is_finite())
      cost.dual = nullptr;
    else
      cost.density = nullptr;
  }
  return cost;
}

/// Why there is no bracket of a problem; empty: there may be one.
std::string why_no_bracket(const Problem& problem) {
  const ConstraintManifold& domain = *problem.manifold;
  if (problem.ring || problem.based) return "a bracket is of the cost between two ends, and a ring has none";
  if ((domain.shape() != Shape::flat && find_ability<HasWalls>(domain) == nullptr) ||
      domain.dimensions().coordinate != 2)
    return "a bracket needs the plane: a flat domain with two coordinates";
  if (find_ability<ChecksMoves>(domain) != nullptr && walls_in_plane(domain) == nullptr)
    return "a bracket needs obstacles that are balls, boxes, polygons or maps in the plane";
  if (box_of(domain).isEmpty()) return "a bracket speaks of the paths in a box: give the manifold finite bounds";
  if (!in_cells(problem)) return "a bracket needs a cost by formula: bounds of a black box would prove nothing";
  return "";
}

GlobalBound blocked(std::string reason) {
  GlobalBound out;
  out.outcome = "blocked";
  out.scope = "global";
  out.gap = 1;
  out.counts = "cells";
  out.bound = "potential";
  out.reason = std::move(reason);
  return out;
}

std::string why_nothing_proved(const Bracket& bracket) {
  if (bracket.stopped && bracket.grids == 0) return "its time was up before the first grid was done";
  return "nothing is proved on these grids: the ends are too near to each other or to where the cost is singular";
}

/// The smooth curve through the points, or the moves between them where that curve meets an obstacle.
Eigen::Matrix2Xd feasible_polyline(const Problem& problem, const Points& chain, const Eigen::AlignedBox2d& box) {
  Eigen::Matrix2Xd smooth = smooth_polyline(chain, box);
  const auto clearance = measure_clearance(*problem.manifold, smooth, false, {});
  return clearance && clearance->lower < 0 ? Eigen::Matrix2Xd(chain) : smooth;
}

/// Whether a way goes round the obstacles as the curve does, as far as that is known.
bool passes_alike(const Problem& problem, const Eigen::Matrix2Xd& way, const Points& curve) {
  return way.cols() < 2 || find_ability<ChecksMoves>(*problem.manifold)->same_class(way, curve).value_or(true);
}

Bracket bracket_of(const Problem& problem, const CostInCells& cost, double upper, const GlobalBudget& budget,
                   const std::function<bool(const Eigen::Matrix2Xd&)>& takes_way, const Monitor& monitor) {
  BracketOptions options;
  options.tolerance = budget.tolerance;
  if (budget.max_windows) options.max_searched = *budget.max_windows;
  if (const Walls* walls = walls_in_plane(*problem.manifold))
    options.depth = [walls](const Vector2d& x) { return -walls->clearance(x, x).upper; };
  options.stop = stop_of_search(budget, monitor);
  options.takes_way = takes_way;
  const auto of = [&](const auto& known) {
    return bracket_least_cost(known, box_of(*problem.manifold), problem.source.u, problem.target.u, upper, options);
  };
  return cost.dual != nullptr ? of(*cost.dual) : of(*cost.density);
}

}  // namespace

BracketPostProcessor::BracketPostProcessor(GlobalBudget budget)
    : budget_(std::move(budget)), kept_(std::make_shared<KeptBracket>()) {}

PostProcessed BracketPostProcessor::apply(const Problem& problem, const FirstPath&, PostProcessed current,
                                          const Monitor& monitor) const {
  if (monitor.interrupted()) return current;
  if (std::string why = why_no_bracket(problem); !why.empty()) {
    current.curve.global = blocked(std::move(why));
    return current;
  }
  const auto begin = Monitor::Clock::now();
  const CostInCells cost = in_cells(problem);
  for (const bool is_source : {true, false}) {
    if (cost.is_known_at(is_source ? problem.source.u : problem.target.u)) continue;
    current.curve.global =
        blocked(std::string("the cost has no finite bounds beside the ") + (is_source ? "source" : "target"));
    return current;
  }
  const Eigen::AlignedBox2d box = box_of(*problem.manifold);
  const double upper = cost.above(feasible_polyline(problem, current.chain.u, box));

  const std::lock_guard<std::mutex> guard(kept_->lock);
  KeptBracket& kept = *kept_;
  const Walls* walls = walls_in_plane(*problem.manifold);
  const bool same_problem = kept.cost == problem.cost && kept.walls == walls && kept.box.isApprox(box, 0) &&
                            kept.source == problem.source.u && kept.target == problem.target.u;
  const bool again = same_problem && !kept.bracket.way_taken && upper <= kept.bracket.upper * (1 + budget_.tolerance);
  const bool among = find_ability<ChecksMoves>(*problem.manifold) != nullptr;
  if (!again) {
    kept.cost = problem.cost;
    kept.domain = problem.manifold;
    kept.walls = walls;
    kept.box = box;
    kept.source = problem.source.u;
    kept.target = problem.target.u;
    if (!same_problem) kept.left = 0;
    std::function<bool(const Eigen::Matrix2Xd&)> takes_way;
    if (among && !(kept.left > 0))
      takes_way = [&](const Eigen::Matrix2Xd& way) {
        return cost.above(way) < kClearlyLess * upper && !passes_alike(problem, way, current.curve.x);
      };
    kept.bracket = bracket_of(problem, cost, upper, budget_, takes_way, monitor);
  }
  const Bracket& bracket = kept.bracket;
  const double seconds = std::chrono::duration<double>(Monitor::Clock::now() - begin).count();
  kept.seconds = again ? kept.seconds + seconds : seconds;

  GlobalBound global;
  global.scope = "global";
  global.counts = "cells";
  global.bound = "potential";
  global.steps = bracket.cells;
  global.lower_bound = bracket.lower;
  global.gap = bracket.lower < upper ? (upper - bracket.lower) / upper : 0;
  global.proved = bracket.lower > 0 && global.gap <= budget_.tolerance;
  global.grid = BoundGrid{box, bracket.grid, upper};
  if (bracket.potential) global.grid->potential = samples_of(*bracket.potential);
  const bool cheaper = among ? !passes_alike(problem, bracket.way, current.curve.x)
                             : bracket.upper < upper * (1 - budget_.tolerance / 4);
  if (!again && bracket.way.cols() > 1 && cheaper) {
    current.cheaper = CoordinatePath{bracket.way, {}, false};
    if (!(kept.left > 0)) kept.left = upper;
  }
  global.outcome = !global.proved ? "bounded" : upper < kept.left ? "improved" : "proved";
  if (bracket.lower == 0) {
    global.reason = why_nothing_proved(bracket);
    if (!global.reason.empty()) global.outcome = "blocked";
  }
  global.seconds = kept.seconds;
  current.curve.global = std::move(global);
  return current;
}

}  // namespace leastcost
