// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/bracket.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/has_origin.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/bracket/search/bracket.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include "problems/bracket/search/potential_samples.hpp"
#include "problems/bracket/smooth_polyline.hpp"
#include "problems/post_processors/search_time.hpp"
#include "problems/post_processors/way_among_obstacles.hpp"
#include "problems/raster/has_cell_index.hpp"

namespace leastcost {

/// What a bracket says, in the plane or in space.
struct BracketInBox {
  double lower = 0, upper = 0;
  Points way = {};
  std::vector<int> grid = {};
  long cells = 0;
  int grids = 0;
  bool stopped = false;
  bool way_taken = false;  ///< the search has ended with takes_way
  PotentialSamples potential = {};
};

/// The bracket of the problem that was asked for last.
struct KeptBracket {
  std::mutex lock;
  std::shared_ptr<const SegmentCost> cost;  // kept alive, hence its address is its own
  std::shared_ptr<const ConstraintManifold> domain;
  const Walls* walls = nullptr;  // of the domain; margins fitted to a chain make another domain of the same walls
  Eigen::AlignedBoxXd box;
  BracketInBox bracket;
  Eigen::VectorXd source, target;
  double seconds = 0;
  double left = 0;  ///< cost of the path from which another way was offered; 0: none was

  bool is_of(const Problem& problem, const Walls* among, const Eigen::AlignedBoxXd& in) const {
    return cost == problem.cost && walls == among && box.dim() == in.dim() && box.isApprox(in, 0) &&
           source == problem.source.u && target == problem.target.u;
  }
};

namespace {

using Eigen::Vector2d;

Eigen::Index dimension_of(const Problem& problem) { return problem.manifold->dimensions().coordinate; }

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Than a path: chains beside obstacles are dearer than the curve by less.
constexpr double kClearlyLess = 0.995;

/// The box that all paths stay in: that of the domain, or the part in it of a cost map in the plane, beyond which the
/// cost is infinite; empty where there is none.
Eigen::AlignedBoxXd box_of(const Problem& problem) {
  const Eigen::Index dimension = dimension_of(problem);
  Eigen::AlignedBoxXd box(Eigen::VectorXd::Constant(dimension, -kUnknown),
                          Eigen::VectorXd::Constant(dimension, kUnknown));
  if (const auto* bounds = find_ability<HasBox>(*problem.manifold)) box = {bounds->box_lower(), bounds->box_upper()};
  const auto is_finite = [&box] { return box.min().allFinite() && box.max().allFinite(); };
  const auto* map = find_ability<HasCellIndex>(*problem.cost);
  if (!is_finite() && map != nullptr && dimension == 2)
    box = box.intersection(
        Eigen::AlignedBoxXd(Eigen::VectorXd(map->patches().lower()), Eigen::VectorXd(map->patches().upper())));
  return is_finite() ? box : Eigen::AlignedBoxXd(dimension);
}

/// The same box, of a dimension that is known.
template <int Dimension>
Eigen::AlignedBox<double, Dimension> fixed(const Eigen::AlignedBoxXd& box) {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  return {Vector(box.min()), Vector(box.max())};
}

/// Obstacles in the plane or in space itself, whose gaps are distances there; null: there are none.
const Walls* walls_in_place(const ConstraintManifold& domain) {
  const auto* among = find_ability<HasWalls>(domain);
  if (among == nullptr || find_ability<HasOrigin>(domain) != nullptr) return nullptr;
  const Walls& walls = among->walls();
  const bool distances = find_ability<GapsAreDistances>(walls) != nullptr;
  return distances && walls.dimension() == domain.dimensions().coordinate ? &walls : nullptr;
}

/// Whether there are moves in every direction from a place.
bool has_all_moves(const CoordinateCost& cost, const Vector2d& place) {
  constexpr int kDirections = 32;
  const CoordinateCost::Element element(cost, place);
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * k / kDirections;
    if (!std::isfinite(element({std::cos(angle), std::sin(angle)}))) return false;
  }
  return true;
}

/// What is known of a cost in cells: one of these, or none.
struct CostInCells {
  std::shared_ptr<const CostDensity> density;
  std::shared_ptr<const CostDual> dual;
  std::shared_ptr<const SpaceDensity> space;
  std::shared_ptr<const CoordinateCost> values;  ///< nothing is proved of it

  explicit operator bool() const {
    return density != nullptr || dual != nullptr || space != nullptr || values != nullptr;
  }
  double above(const Points& x) const {
    if (values != nullptr) return polyline_cost(*values, Eigen::Matrix2Xd(x));
    if (space != nullptr) return polyline_cost_above(*space, Eigen::Matrix3Xd(x));
    return dual != nullptr ? polyline_cost_above(*dual, Eigen::Matrix2Xd(x))
                           : polyline_cost_above(*density, Eigen::Matrix2Xd(x));
  }
  bool is_known_at(const Eigen::VectorXd& place) const {
    if (space != nullptr) {
      const Eigen::Vector3d x = place;
      return space->enclose_density({x, x}).is_finite();
    }
    const Vector2d x = place;
    if (values != nullptr) return has_all_moves(*values, x);
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

/// The same of the line element of a cost in space.
bool looks_isotropic(const SegmentCost& cost, const Eigen::AlignedBoxXd& box) {
  constexpr double kRounding = 1e-9;
  constexpr int kPlaces = 5;
  for (int k = 0; k < kPlaces; ++k) {
    const Eigen::Vector3d part(0.1 + 0.19 * k, std::fmod(0.07 + 0.41 * k, 1.0), std::fmod(0.13 + 0.29 * k, 1.0));
    const Eigen::VectorXd x = box.min() + box.sizes().cwiseProduct(part);
    const auto along = [&](const Eigen::Vector3d& d) { return cost.line_element(x, Eigen::VectorXd(d.normalized())); };
    const double n = along(Eigen::Vector3d::UnitX());
    if (!std::isfinite(n)) continue;
    for (const Eigen::Vector3d& d : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 1, 1),
                                     Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, -2, 1)})
      if (std::abs(along(d) - n) > kRounding * n) return false;
  }
  return true;
}

/// Both bounds hold for every metric; that of a density is narrow where the metric is the same in all directions. In
/// two coordinates what has none of them at both ends is known by its values.
CostInCells in_cells(const Problem& problem) {
  if (dimension_of(problem) == 3) return {nullptr, nullptr, space_density_of(problem.cost), nullptr};
  const bool flat = find_ability<HasChart>(*problem.manifold) == nullptr;
  CostInCells cost;
  if (flat) cost = {density_of(problem.cost), dual_of(problem.cost), nullptr, nullptr};
  if (cost.density != nullptr && cost.dual != nullptr) {
    const Vector2d source = problem.source.u;
    if (looks_isotropic(*cost.dual, fixed<2>(box_of(problem))) &&
        cost.density->enclose_density({source, source}).is_finite())
      cost.dual = nullptr;
    else
      cost.density = nullptr;
  }
  if (!cost || !cost.is_known_at(problem.source.u) || !cost.is_known_at(problem.target.u))
    return {nullptr, nullptr, nullptr, std::make_shared<const CoordinateCost>(problem.manifold, problem.cost)};
  return cost;
}

/// Whether two coordinates name the places of a domain, none of them by two.
bool has_plain_coordinates(const ConstraintManifold& domain) {
  if (domain.dimensions().coordinate != 2) return false;
  const auto* chart = find_ability<HasChart>(domain);
  const auto* seams = find_ability<HasSeams>(domain);
  return chart != nullptr && chart->poles().empty() && (seams == nullptr || seams->seams().empty());
}

/// Why there is no bracket of a problem; empty: there may be one.
GlobalBound blocked(std::string reason) {
  GlobalBound out;
  out.outcome = ProofOutcome::blocked;
  out.scope = Scope::global;
  out.gap = 1;
  out.counts = "cells";
  out.bound = "potential";
  out.reason = std::move(reason);
  return out;
}

std::string why_nothing_proved(const BracketInBox& bracket) {
  if (bracket.stopped && bracket.grids == 0) return "the time was used up before the first grid was finished";
  return "nothing is proved on these grids: the ends are too close to each other or to a singularity of the cost";
}

/// What the smooth curve through the points costs, or the moves between them where that curve meets an obstacle or
/// leaves the domain.
double cost_of_feasible(const Problem& problem, const CostInCells& cost, const Points& chain,
                        const Eigen::AlignedBoxXd& box) {
  const Points smooth = smooth_polyline(chain, box);
  const auto clearance = measure_clearance(*problem.manifold, smooth, false, {});
  const double of_smooth = clearance && clearance->lower < 0 ? kUnknown : cost.above(smooth);
  return std::isfinite(of_smooth) ? of_smooth : cost.above(chain);
}

/// Whether a way is known to go round the obstacles as the curve does: then it is the curve that it would become.
bool passes_alike(const Problem& problem, const Points& way, const Points& curve) {
  return find_ability<ChecksMoves>(*problem.manifold)->same_class(way, curve).value_or(false);
}

/// How deep a place lies within an obstacle, at most its distance from all places outside, for gaps grow by no more
/// than the way; 0 outside.
double depth_within(const Walls& walls, const Eigen::VectorXd& x) {
  std::vector<Wall> found;
  walls.near(x, 0, found);
  double deepest = 0;
  for (const Wall& wall : found) deepest = std::max(deepest, -wall.gap);
  return deepest;
}

using TakesWay = std::function<bool(const Points&)>;

template <int N>
BoxBracketOptions<N> options_of_bracket(const Problem& problem, const GlobalBudget& budget, const TakesWay& takes_way,
                                        const Monitor& monitor) {
  BoxBracketOptions<N> options;
  options.tolerance = budget.tolerance;
  if (budget.max_windows) options.max_searched = *budget.max_windows;
  if (const Walls* walls = walls_in_place(*problem.manifold))
    options.depth = [walls](const Eigen::Matrix<double, N, 1>& x) { return depth_within(*walls, x); };
  options.stop = stop_of_search(budget, monitor);
  options.takes_way = takes_way;
  return options;
}

template <int N>
BracketInBox in_box_of(const BoxBracket<N>& found) {
  return {found.lower, found.upper, found.way,     {found.grid.begin(), found.grid.end()},
          found.cells, found.grids, found.stopped, found.way_taken};
}

BracketInBox bracket_of(const Problem& problem, const CostInCells& cost, double upper, const GlobalBudget& budget,
                        const TakesWay& takes_way, const Monitor& monitor) {
  const Eigen::AlignedBoxXd box = box_of(problem);
  if (cost.space != nullptr)
    return in_box_of(bracket_least_cost(*cost.space, fixed<3>(box), problem.source.u, problem.target.u, upper,
                                        options_of_bracket<3>(problem, budget, takes_way, monitor)));
  auto options = options_of_bracket<2>(problem, budget, takes_way, monitor);
  constexpr double kMostByValues = 1e6;  // cells: what is known of each takes half a kilobyte
  if (cost.values != nullptr) options.max_searched = std::min(options.max_searched, kMostByValues);
  const auto of = [&](const auto& known) {
    const Bracket found = bracket_least_cost(known, fixed<2>(box), problem.source.u, problem.target.u, upper, options);
    BracketInBox out = in_box_of(found);
    if (found.potential) out.potential = samples_of(*found.potential);
    return out;
  };
  if (cost.values != nullptr) return of(*cost.values);
  return cost.dual != nullptr ? of(*cost.dual) : of(*cost.density);
}

}  // namespace

std::string why_no_bracket(const Problem& problem) {
  const ConstraintManifold& domain = *problem.manifold;
  if (problem.ring || problem.based) return "a bracket needs two ends, but a ring has none";
  const bool flat = domain.shape() == Shape::flat || find_ability<HasWalls>(domain) != nullptr;
  if (!(flat && (dimension_of(problem) == 2 || dimension_of(problem) == 3)) && !has_plain_coordinates(domain))
    return "a bracket needs a flat domain with two or three coordinates, or terrain";
  if (find_ability<ChecksMoves>(domain) != nullptr && walls_in_place(domain) == nullptr)
    return "a bracket needs obstacles in the plane or space itself: balls, boxes, polygons, maps, meshes";
  if (box_of(problem).isEmpty()) return "a bracket needs a box: give the manifold finite bounds";
  const CostInCells cost = in_cells(problem);
  if (cost.space != nullptr && !looks_isotropic(*problem.cost, box_of(problem)))
    return "a bracket in space needs an isotropic cost";
  if (!cost) return "a bracket in space needs a cost given by a formula";
  return "";
}

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
        blocked(std::string("the cost has no finite bounds near the ") + (is_source ? "source" : "target"));
    return current;
  }
  const Eigen::AlignedBoxXd box = box_of(problem);
  const double upper = cost_of_feasible(problem, cost, current.chain.u, box);
  if (!std::isfinite(upper)) {
    current.curve.global = blocked("between its points, the path crosses places where the cost has no finite bounds");
    return current;
  }

  const std::lock_guard<std::mutex> guard(kept_->lock);
  KeptBracket& kept = *kept_;
  const Walls* walls = walls_in_place(*problem.manifold);
  const bool same_problem = kept.is_of(problem, walls, box);
  const bool again = same_problem && !kept.bracket.way_taken && upper <= kept.bracket.upper * (1 + budget_.tolerance);
  const bool among = find_ability<ChecksMoves>(*problem.manifold) != nullptr;
  const auto better_way = [&](const Points& way) -> std::optional<Points> {
    if (way.cols() < 2) return std::nullopt;
    if (!among) return cost.above(way) < upper * (1 - budget_.tolerance / 4) ? std::optional(way) : std::nullopt;
    std::optional<Points> placed = way_among_obstacles(problem, way);
    const bool better =
        placed && cost.above(*placed) < kClearlyLess * upper && !passes_alike(problem, *placed, current.curve.x);
    return better ? placed : std::nullopt;
  };
  if (!again) {
    kept.cost = problem.cost;
    kept.domain = problem.manifold;
    kept.walls = walls;
    kept.box = box;
    kept.source = problem.source.u;
    kept.target = problem.target.u;
    if (!same_problem) kept.left = 0;
    TakesWay takes_way;
    if (among && !(kept.left > 0)) takes_way = [&](const Points& way) { return better_way(way).has_value(); };
    kept.bracket = bracket_of(problem, cost, upper, budget_, takes_way, monitor);
  }
  const BracketInBox& bracket = kept.bracket;
  const double seconds = std::chrono::duration<double>(Monitor::Clock::now() - begin).count();
  kept.seconds = again ? kept.seconds + seconds : seconds;

  GlobalBound global;
  global.scope = Scope::global;
  global.counts = "cells";
  global.bound = "potential";
  global.steps = bracket.cells;
  global.lower_bound = bracket.lower;
  global.gap = bracket.lower < upper ? (upper - bracket.lower) / upper : 0;
  const bool narrow = bracket.lower > 0 && global.gap <= budget_.tolerance;
  global.category = cost.values != nullptr ? BoundCategory::sampled : BoundCategory::proved;
  global.proved = narrow && global.category == BoundCategory::proved;
  global.grid = BoundGrid{box, bracket.grid, upper, bracket.potential};
  if (!again) {
    if (const auto way = better_way(bracket.way)) current.cheaper = CoordinatePath{*way, {}, false};
    if (current.cheaper && !(kept.left > 0)) kept.left = upper;
  }
  global.outcome = !narrow             ? ProofOutcome::bounded
                   : !global.proved    ? ProofOutcome::sampled
                   : upper < kept.left ? ProofOutcome::improved
                                       : ProofOutcome::proved;
  if (bracket.lower == 0) {
    global.reason = why_nothing_proved(bracket);
    if (!global.reason.empty()) global.outcome = ProofOutcome::blocked;
  }
  global.seconds = kept.seconds;
  current.curve.global = std::move(global);
  return current;
}

}  // namespace leastcost
