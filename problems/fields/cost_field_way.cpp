// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The way down a field of least costs.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/problems/fields/cost_field.hpp>
#include <leastcost/problems/fields/space_field.hpp>
#include "framework/base/point_text.hpp"
#include "problems/fields/arrival_field.hpp"
#include "problems/fields/closed_lattice.hpp"
#include "problems/fields/field_descent.hpp"
#include "problems/fields/grid_search.hpp"
#include "problems/fields/lattice_box.hpp"
#include "problems/fields/no_way.hpp"
#include "problems/fields/tightened_way.hpp"
#include "problems/fields/without_cost.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kImpossible = std::numeric_limits<double>::infinity();

/// The same by a field of arrivals at the target, whose nodes know where their last move came from: where a current
/// leaves few directions, the values alone do not say it. Without points where that is lost too.
/// `finer`: so many times as many cells along each side.
std::vector<Vector2d> way_by_arrivals(const CostField& field, const Problem& problem, const Vector2d& place,
                                      std::int32_t finer) {
  const LatticeBox box{field.lower, field.node(field.count[0] - 1, field.count[1] - 1), {}, {}};
  ArrivalField::Way how;
  how.cells = {finer * (field.count[0] - 1), finer * (field.count[1] - 1)};
  std::vector<Vector2d> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& other : field.places) {
    Problem between = problem;
    between.source.u = field.to_places ? Eigen::VectorXd(place) : other;
    between.target.u = field.to_places ? other : Eigen::VectorXd(place);
    const MoveCheck moves(between);
    const ArrivalField arrivals(between, moves, box, 0, how, [] { return false; });
    if (!arrivals.arrival_cost() || !(*arrivals.arrival_cost() < least)) continue;
    try {
      best = arrivals.way();
      least = *arrivals.arrival_cost();
    } catch (const InitializationError&) {  // lost between the nodes
      continue;
    }
  }
  return best;
}

double cost_or_infinite(const Problem& problem, const std::vector<Vector2d>& way) {
  return way.empty() ? kImpossible : cost_of_way(problem, way);
}

/// Where a current leaves few directions, a move whose middle can be crossed may not be possible in pieces: the
/// cheapest of ways on finer and finer lattices, or `way`.
std::vector<Vector2d> way_in_current(const CostField& field, const Problem& problem, const Vector2d& place,
                                     std::vector<Vector2d> way) {
  constexpr std::size_t kMostNodes = 600'000;  // of which carried ones take 0.01 ms each
  constexpr int kWays = 2;                     // one alone may be far from the best
  int found = 0;
  for (const std::int32_t finer : {1, 2, 4}) {
    const std::size_t nodes = std::size_t(finer) * std::size_t(finer) * field.values.size();
    if (found == kWays || (finer > 1 && nodes > kMostNodes)) break;
    std::vector<Vector2d> other = way_by_arrivals(field, problem, place, finer);
    const double cost = cost_or_infinite(problem, other);
    if (cost < kImpossible) ++found;
    if (way.empty() || cost < cost_or_infinite(problem, way)) way = std::move(other);
  }
  return way;
}

/// The same field beyond its seams, on which ways go across them.
CostField laid_out(const CostField& field) {
  const LaidOut wide({field.lower, field.step, field.count}, field.seams);
  CostField out = field;
  out.seams.clear();
  out.poles.clear();
  out.lower = wide.lattice().lower, out.count = wide.lattice().count;
  out.values = wide.unfolded(field.values);
  out.places = wide.images(field.places);
  return out;
}

}  // namespace

std::vector<Vector2d> way_down(const CostField& field, const Problem& problem, const Vector2d& place) {
  if (!place.allFinite()) throw InputError("field: a place needs two finite coordinates");
  if (!field.seams.empty())
    return way_down(laid_out(field), problem,
                    in_period({field.lower, field.step, field.count}, field.seams, field.poles, place));
  const Vector2d last = field.node(field.count[0] - 1, field.count[1] - 1);
  if (((place - field.lower + field.step).array() < 0).any() || ((last + field.step - place).array() < 0).any())
    throw InputError("field: the place " + point_text(place) + " is outside the field, which reaches from " +
                     point_text(field.lower) + " to " + point_text(last));
  if (!is_reached(field, place))
    throw NoWay("field: no path leads " + std::string(field.to_places ? "from" : "to") + " the place " +
                point_text(place) + ": it has no data, or obstacles or places without data lie between");
  std::vector<Vector2d> way = steepest_way(field, problem, place);
  if (!field.to_places) std::reverse(way.begin(), way.end());
  if (!(cost_or_infinite(problem, way) < kImpossible)) way = way_in_current(field, problem, place, std::move(way));
  const std::string why = way.empty() ? why_without_cost(problem, place) : "";
  if (!why.empty())
    throw InputError("field: there is no way " + std::string(field.to_places ? "from" : "to") + " the place " +
                     point_text(place) + ": " + why);
  if (way.empty())
    throw InputError("field: the way " + std::string(field.to_places ? "from" : "to") + " the place " +
                     point_text(place) + " is lost between the nodes: use a smaller resolution");
  std::vector<Vector2d> tight = tightened(problem, way, field.step.minCoeff(), {field.lower, last});
  return cost_of_way(problem, tight) < cost_of_way(problem, way) ? tight : way;
}

double value_at(const CostField& field, const Vector2d& place) {
  const Vector2d named = in_period({field.lower, field.step, field.count}, field.seams, field.poles, place);
  const Vector2d at = (named - field.lower).cwiseQuotient(field.step);
  const auto low = [&](std::size_t d) {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(at[static_cast<Eigen::Index>(d)]), 0.0, field.count[d] - 2.0));
  };
  const std::int32_t i = low(0), j = low(1);
  const double s = std::clamp(at[0] - i, 0.0, 1.0), t = std::clamp(at[1] - j, 0.0, 1.0);
  double sum = 0;
  for (const auto& [weight, value] :
       {std::pair((1 - s) * (1 - t), field.value(i, j)), std::pair(s * (1 - t), field.value(i + 1, j)),
        std::pair((1 - s) * t, field.value(i, j + 1)), std::pair(s * t, field.value(i + 1, j + 1))})
    if (weight > 0) sum += weight * value;  // at a node the others do not matter, and may have none
  return sum;
}

namespace {

template <class Place>
double cost_in_pieces(const Problem& problem, const std::vector<Place>& way, Index pieces) {
  const auto moves = static_cast<Index>(way.size()) - 1;
  CoordinatePath fine{Points(Place::RowsAtCompileTime, moves * pieces + 1), {}, false};
  for (Index i = 0; i < moves; ++i) {
    const Place &a = way[static_cast<std::size_t>(i)], &b = way[static_cast<std::size_t>(i) + 1];
    for (Index k = 0; k < pieces; ++k) fine.u.col(i * pieces + k) = a + double(k) / double(pieces) * (b - a);
  }
  fine.u.rightCols(1) = way.back();
  return PathEnergy(problem, 1).cost(fine);
}

/// On a curved domain chords are too short: pieces are halved until the cost no longer changes.
template <class Place>
double cost_in_pieces(const Problem& problem, const std::vector<Place>& way) {
  constexpr Index kPieces = 4, kMostPieces = 64;  // of a move, which is two cells long
  constexpr double kSame = 1e-8;                  // of the cost
  if (way.size() < 2) return 0;
  double cost = cost_in_pieces(problem, way, kPieces);
  for (Index pieces = 2 * kPieces; pieces <= kMostPieces; pieces *= 2) {
    const double before = cost;
    cost = cost_in_pieces(problem, way, pieces);
    if (!std::isfinite(cost)) return before;  // in a current that the middle of a longer piece can be crossed in
    if (!(std::abs(cost - before) > kSame * cost)) break;
  }
  return cost;
}

}  // namespace

double cost_of_way(const Problem& problem, const std::vector<Vector2d>& way) { return cost_in_pieces(problem, way); }

double cost_of_way(const Problem& problem, const std::vector<Eigen::Vector3d>& way) {
  return cost_in_pieces(problem, way);
}

}  // namespace leastcost
