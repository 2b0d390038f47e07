// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/fields/space_field.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include "framework/base/point_text.hpp"
#include "problems/fields/drift_metric.hpp"
#include "problems/fields/field_error.hpp"
#include "problems/fields/field_lattice.hpp"
#include "problems/fields/grid_search.hpp"
#include "problems/fields/no_way.hpp"
#include "problems/fields/space_arrival.hpp"
#include "problems/fields/space_march.hpp"
#include "problems/fields/tightened_way.hpp"
#include "problems/fields/without_cost.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Lattice3 = SpaceMarch::Lattice;

constexpr double kNoWay = std::numeric_limits<double>::infinity();

void check_space(const Problem& problem) {
  if (problem.ring) throw InputError("field: a ring has no source: give ends");
  if (!is_in_space(problem)) throw InputError("field: needs space, or a box of it");
}

/// A unit of length costs the same in all directions.
bool is_isotropic_in_space(const Problem& problem) {
  const auto* conformal = find_ability<HasConformalMetric>(*problem.cost);
  return MoveCheck(problem).euclidean() || (conformal != nullptr && conformal->base().isIdentity(0));
}

/// The line elements at the nodes; of the reverse moves where costs to places are asked.
std::vector<DriftMetric> elements_in_space(const Problem& problem, const Lattice3& lattice, bool to_places) {
  std::vector<DriftMetric> elements;
  elements.reserve(static_cast<std::size_t>(lattice.count[0]) * static_cast<std::size_t>(lattice.count[1]) *
                   static_cast<std::size_t>(lattice.count[2]));
  for (std::int32_t k = 0; k < lattice.count[2]; ++k)
    for (std::int32_t j = 0; j < lattice.count[1]; ++j)
      for (std::int32_t i = 0; i < lattice.count[0]; ++i) {
        const Vector3d x = lattice.place(i, j, k);
        std::optional<DriftMetric> element = drift_metric_at(*problem.cost, x);
        if (!element)
          throw InputError(
              "field: in three coordinates the cost must be a metric, or the time in a wind that is "
              "weaker than the speed; at " +
              point_text(x) + " it is neither. leastcost run gives the least cost between two places");
        if (to_places)
          for (double& drift : element->b) drift = -drift;
        elements.push_back(*element);
      }
  return elements;
}

std::vector<double> densities_in_space(const Problem& problem, const Lattice3& lattice) {
  const bool euclidean = MoveCheck(problem).euclidean();
  const Eigen::VectorXd unit = Vector3d(1, 0, 0);
  std::vector<double> n;
  n.reserve(static_cast<std::size_t>(lattice.count[0]) * static_cast<std::size_t>(lattice.count[1]) *
            static_cast<std::size_t>(lattice.count[2]));
  for (std::int32_t k = 0; k < lattice.count[2]; ++k)
    for (std::int32_t j = 0; j < lattice.count[1]; ++j)
      for (std::int32_t i = 0; i < lattice.count[0]; ++i) {
        const Vector3d x = lattice.place(i, j, k);
        n.push_back(euclidean ? 1 : problem.cost->line_element(x, unit));
      }
  return n;
}

Lattice3 lattice_in_space(const LatticeBox& box, const std::optional<double>& resolution, bool isotropic) {
  // A node takes 40 bytes while the front runs, and 200 and about fifty times as long if the direction counts.
  const double kCells = isotropic ? 80 : 40, kMostSpaceNodes = isotropic ? 3e7 : 3e6;
  const Vector3d size = box.upper - box.lower;
  check_extent(box);
  check_resolution(resolution, size);
  Lattice3 lattice{box.lower, Vector3d::Zero(), {}};
  double nodes = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto axis = static_cast<Eigen::Index>(d);
    lattice.step[axis] = resolution ? *resolution : std::min(size.maxCoeff() / kCells, size[axis] / kFewestCells);
    const double cells = std::min(cells_to_edge(size[axis], lattice.step[axis]), kMostSpaceNodes);
    lattice.count[d] = static_cast<std::int32_t>(cells) + 1;
    nodes *= cells + 1;
  }
  if (!(nodes <= kMostSpaceNodes))
    throw OptionError("resolution", std::string("gives more than ") + (isotropic ? "30" : "3") +
                                        " million nodes: choose a larger one");
  return lattice;
}

Lattice3 every_second_in_space(const Lattice3& lattice) {
  Lattice3 half = lattice;
  half.step *= 2;
  for (std::int32_t& count : half.count) count = (count - 1) / 2 + 1;
  return half;
}

template <class Value>
std::vector<Value> every_second_in_space(const std::vector<Value>& values, const Lattice3& lattice) {
  std::vector<Value> half;
  half.reserve(values.size() / 4);
  for (std::int32_t k = 0; k < lattice.count[2]; k += 2)
    for (std::int32_t j = 0; j < lattice.count[1]; j += 2)
      for (std::int32_t i = 0; i < lattice.count[0]; i += 2)
        half.push_back(values[(static_cast<std::size_t>(k) * static_cast<std::size_t>(lattice.count[1]) +
                               static_cast<std::size_t>(j)) *
                                  static_cast<std::size_t>(lattice.count[0]) +
                              static_cast<std::size_t>(i)]);
  return half;
}

void check_places_in_space(const std::vector<Eigen::VectorXd>& places, const LatticeBox& box) {
  constexpr double kRounding = 1e-9;
  if (places.empty()) throw InputError("field: give at least one place");
  const double tolerance = kRounding * (box.upper - box.lower).maxCoeff();
  for (const Eigen::VectorXd& place : places) {
    if (place.size() != 3 || !place.allFinite())
      throw InputError("field: a place needs three finite coordinates (found " + point_text(place) + ")");
    if (((place - box.lower).array() < -tolerance).any() || ((box.upper - place).array() < -tolerance).any())
      throw InputError("field: the place " + point_text(place) + " is outside the box from " + point_text(box.lower) +
                       " to " + point_text(box.upper));
  }
}

/// `March`: SpaceMarch from densities, SpaceArrival from line elements.
template <class March, class Local>
std::vector<double> marched_in_space(const Problem& problem, const SpaceField& field, const Lattice3& lattice,
                                     const std::vector<Local>& locals, const Monitor& monitor) {
  const MoveCheck moves(problem);
  SpaceMarch::Passes passes;
  if (moves.among_obstacles())
    passes = [&moves](const Vector3d& a, const Vector3d& b) { return moves.clear(a, b, kNoWay); };
  March march(lattice, locals, passes);
  for (const Eigen::VectorXd& place : field.places)
    march.start(place, [&](const Vector3d& a, const Vector3d& b) {
      return field.to_places ? moves.cost(b, a) : moves.cost(a, b);
    });
  march.run([&monitor] { return monitor.interrupted(); });
  return march.values();
}

/// The values of a field, and those on every second node where an error is estimated.
template <class March, class Local>
std::vector<double> fill_in_space(const Problem& problem, const Lattice3& lattice, const std::vector<Local>& locals,
                                  bool twice, const Monitor& monitor, SpaceField& field) {
  field.values = marched_in_space<March>(problem, field, lattice, locals, monitor);
  if (!twice) return {};
  return marched_in_space<March>(problem, field, every_second_in_space(lattice), every_second_in_space(locals, lattice),
                                 monitor);
}

/// Calls f with all nodes within so many steps of a place, along each axis.
template <class F>
void for_nodes_near(const SpaceField& field, const Vector3d& x, double reach, const F& f) {
  const Vector3d at = (x - field.lower).cwiseQuotient(field.step);
  std::array<std::int32_t, 3> low{}, high{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double along = at[static_cast<Eigen::Index>(d)];
    low[d] = static_cast<std::int32_t>(std::clamp(std::ceil(along - reach), 0.0, field.count[d] - 1.0));
    high[d] = static_cast<std::int32_t>(std::clamp(std::floor(along + reach), 0.0, field.count[d] - 1.0));
  }
  for (std::int32_t k = low[2]; k <= high[2]; ++k)
    for (std::int32_t j = low[1]; j <= high[1]; ++j)
      for (std::int32_t i = low[0]; i <= high[0]; ++i) f(field.node(i, j, k), field.value(i, j, k));
}

void check_left_in_space(const Problem& problem, const SpaceField& field) {
  constexpr double kNear = 3;  // steps
  for (const Eigen::VectorXd& place : field.places) {
    bool left = false;
    for_nodes_near(field, place, kNear, [&](const Vector3d&, double value) { left = left || std::isfinite(value); });
    if (left) continue;
    std::string why = why_without_cost(problem, place);
    for (Eigen::Index k = 0; why.empty() && k < 6; ++k)
      why = why_without_cost(problem, place + (k < 3 ? 1 : -1) * field.step[k % 3] * Vector3d::Unit(k % 3));
    const std::string what = "field: no path leaves the place " + point_text(place) + ": " +
                             (!why.empty() ? why : "obstacles enclose it, or the steps of the lattice are too long");
    if (!why_without_cost(problem, place).empty()) throw InputError(what);
    throw NoWay(what);
  }
}

/// From node to cheaper node down to one of the places, which it ends with; without points where it is lost.
std::vector<Vector3d> node_way(const SpaceField& field, const MoveCheck& moves, const Vector3d& place) {
  constexpr double kReach = 2, kNearPlace = 3.5;  // steps
  const auto move = [&](const Vector3d& before, const Vector3d& x) {
    return field.to_places ? moves.cost(x, before) : moves.cost(before, x);
  };
  std::vector<Vector3d> way = {place};
  double here = kNoWay;
  while (true) {
    const Vector3d x = way.back();
    double best = kNoWay, value_there = kNoWay;
    Vector3d next = x;
    bool ends = false;
    for (const Eigen::VectorXd& end : field.places) {
      if ((end - x).cwiseQuotient(field.step).norm() > kNearPlace) continue;
      const double cost = move(end, x);
      if (cost < best && moves.clear(end, x, kNoWay)) best = cost, next = end, ends = true;
    }
    for_nodes_near(field, x, kReach, [&](const Vector3d& node, double value) {
      if (!(value < here) || node == x) return;
      const double cost = value + move(node, x);
      if (!(cost < best) || !moves.clear(node, x, kNoWay)) return;
      best = cost, value_there = value, next = node, ends = false;
    });
    if (!(best < kNoWay)) return {};
    if (next != x || way.size() == 1) way.push_back(next);
    if (ends) return way;
    here = value_there;
  }
}

}  // namespace

bool is_in_space(const Problem& problem) {
  const ConstraintManifold& domain = *problem.manifold;
  const Dimensions d = domain.dimensions();
  const auto* images = find_ability<HasImages>(domain);
  return d.coordinate == 3 && d.ambient == 3 && d.tangent == 3 && domain.shape() != Shape::polyhedral &&
         find_ability<HasChart>(domain) == nullptr &&
         (images == nullptr || images->images(problem.source.u, problem.source.u, 1).empty());
}

SpaceField space_costs_from(const Problem& problem, const std::vector<Eigen::VectorXd>& places,
                            const CostFieldOptions& options, const Monitor& monitor) {
  check_space(problem);
  const LatticeBox box = field_box(problem, {});
  check_places_in_space(places, box);
  const bool isotropic = is_isotropic_in_space(problem);
  const Lattice3 lattice = lattice_in_space(box, options.resolution, isotropic);
  SpaceField field;
  field.count = lattice.count, field.lower = lattice.lower, field.step = lattice.step;
  field.places = places;
  field.to_places = options.to_places;
  field.directed = !problem.cost->traits().symmetric;
  field.method = isotropic ? "isotropic march" : "arrival field";
  const auto place_of = [&lattice](std::size_t node) -> Eigen::VectorXd {
    const auto number = static_cast<std::int32_t>(node);
    const std::int32_t row = number / lattice.count[0];
    return lattice.place(number % lattice.count[0], row % lattice.count[1], row / lattice.count[1]);
  };
  std::vector<double> coarse;
  if (isotropic) {
    const std::vector<double> densities = densities_in_space(problem, lattice);
    coarse = fill_in_space<SpaceMarch>(problem, lattice, densities, options.estimate_error, monitor, field);
    count_free_nodes(densities, place_of, field);
  } else {
    const std::vector<DriftMetric> elements = elements_in_space(problem, lattice, options.to_places);
    coarse = fill_in_space<SpaceArrival>(problem, lattice, elements, options.estimate_error, monitor, field);
  }
  check_left_in_space(problem, field);
  field.without_cost = why_some_without_cost(problem, field.values, place_of);
  field.enclosed = is_enclosed<3>(field);
  if (field.enclosed) check_cost_at(problem, places);
  if (options.estimate_error) {
    estimate_error(every_second_in_space(field.values, lattice), coarse,
                   isotropic && !MoveCheck(problem).among_obstacles() ? kOfDensities : kFirstOrder, field);
    allow_for_meeting_fronts<3>(field);
  }
  for (double& value : field.values)
    if (!std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
  return field;
}

SpaceField corridor(const SpaceField& from, const SpaceField& to, double known) {
  if (from.count != to.count || from.lower != to.lower || from.step != to.step)
    throw InputError("corridor: the two fields have different nodes");
  SpaceField sum = from;
  if (!add_field(to, known, sum)) throw NoWay("corridor: no path joins the two places");
  return sum;
}

std::vector<Vector3d> way_down(const SpaceField& field, const Problem& problem, const Vector3d& place) {
  const Vector3d last = field.node(field.count[0] - 1, field.count[1] - 1, field.count[2] - 1);
  if (!place.allFinite() || ((place - field.lower + field.step).array() < 0).any() ||
      ((last + field.step - place).array() < 0).any())
    throw InputError("field: the place " + point_text(place) + " is outside the field, which reaches from " +
                     point_text(field.lower) + " to " + point_text(last));
  const MoveCheck moves(problem);
  std::vector<Vector3d> nodes = node_way(field, moves, place);
  if (nodes.empty())
    throw NoWay("field: no path leads " + std::string(field.to_places ? "from" : "to") + " the place " +
                point_text(place) + ": obstacles lie between, or the steps of the lattice are too long");
  if (!field.to_places) std::reverse(nodes.begin(), nodes.end());  // there and back may cost differently
  const std::vector<Eigen::VectorXd> route(nodes.begin(), nodes.end());
  const std::vector<Eigen::VectorXd> straight = with_shortcuts(route, moves, kNoWay, {});
  const std::vector<Vector3d> corners(straight.begin(), straight.end());
  return tightened(problem, corners, field.step.minCoeff(), Eigen::AlignedBox3d(field.lower, last));
}

}  // namespace leastcost
