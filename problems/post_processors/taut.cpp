// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/taut.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/has_constant_metric.hpp>
#include <leastcost/framework/path_energy.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include "problems/taut/taut_path.hpp"

namespace leastcost {
namespace {

constexpr double kLeastExcess = 1e-10;  ///< a full circle is then a polyline of 200,000 sides
constexpr double kMostExcess = 0.01;
constexpr double kOff = 1e-9;  ///< of the length: by so much a point may be off the domain

const Walls& walls_in_the_plane(const Problem& problem) {
  const ConstraintManifold& manifold = *problem.manifold;
  const auto* domain = find_ability<HasWalls>(manifold);
  const Dimensions dimensions = manifold.dimensions();
  if (domain == nullptr || dimensions.coordinate != 2 || dimensions.ambient != 2 ||
      find_ability<HasChart>(manifold) != nullptr || !domain->walls().rounds(Eigen::AlignedBox2d()))
    throw InputError("taut needs the plane with obstacles in it that are balls, boxes, polygons or maps");
  if (problem.ring) throw InputError("taut joins two ends, and this path is a ring");
  return domain->walls();
}

/// The cost of a move of length one, the same in all directions.
double cost_of_length(const Problem& problem) {
  const auto* cost = find_ability<HasConstantMetric>(*problem.cost);
  const Eigen::MatrixXd metric = cost != nullptr ? cost->metric() : Eigen::MatrixXd();
  if (metric.rows() != 2 || !metric.isApprox(metric(0, 0) * Eigen::MatrixXd::Identity(2, 2)))
    throw InputError("taut needs a cost that is the length, or a multiple of it, in all directions");
  return std::sqrt(metric(0, 0));
}

/// `columns` points of a polyline, equally spaced by length, and the lengths between them.
Points spaced_by_length(const Points& polyline, Index columns, Eigen::VectorXd& lengths) {
  Eigen::VectorXd reached(polyline.cols());
  reached[0] = 0;
  for (Index i = 1; i < polyline.cols(); ++i)
    reached[i] = reached[i - 1] + (polyline.col(i) - polyline.col(i - 1)).norm();
  const double total = reached[reached.size() - 1];
  Points points(2, columns);
  lengths.resize(columns - 1);
  Index at = 0;
  double before = 0;
  for (Index k = 0; k < columns; ++k) {
    const double wanted = total * static_cast<double>(k) / static_cast<double>(columns - 1);
    while (at + 2 < reached.size() && reached[at + 1] < wanted) ++at;
    const double side = reached[at + 1] - reached[at];
    const double share = side > 0 ? std::clamp((wanted - reached[at]) / side, 0.0, 1.0) : 0;
    points.col(k) = polyline.col(at) + share * (polyline.col(at + 1) - polyline.col(at));
    const double here = reached[at] + share * side;
    if (k > 0) lengths[k - 1] = here - before;
    before = here;
  }
  points.col(0) = polyline.leftCols(1);
  points.col(columns - 1) = polyline.rightCols(1);
  return points;
}

std::optional<TautPath> shorter(std::optional<TautPath> a, std::optional<TautPath> b) {
  if (!a || (b && b->least < a->least)) return b;
  return a;
}

}  // namespace

void TautOptions::fields(FieldVisitor& visit) {
  visit.field("excess", excess,
              {.help = "By which part of its length the polyline around round corners may be longer than the curve.",
               .minimum = kLeastExcess,
               .maximum = kMostExcess});
}

TautPostProcessor::TautPostProcessor(TautOptions options) : options_(options) {
  if (!(options.excess >= kLeastExcess && options.excess <= kMostExcess))
    throw OptionError("excess", "must be from 1e-10 to 0.01");
}

PostProcessed TautPostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                       const Monitor& monitor) const {
  const Walls& walls = walls_in_the_plane(problem);
  const double unit = cost_of_length(problem);
  std::optional<TautPath> best = taut_path(walls, first.path.u, options_.excess, monitor.deadline);
  if (!best || !of_one_class(walls, first.path.u, current.chain.u))
    best = shorter(std::move(best), taut_path(walls, current.chain.u, options_.excess, monitor.deadline));
  if (!best) {
    current.notes.emplace_back("taut: neither the first path nor the solved one could be pulled tight; it stays");
    return current;
  }
  CoordinatePath chain = current.chain;
  chain.u = spaced_by_length(best->polyline, chain.u.cols(), current.curve_costs);
  current.curve_costs *= unit;
  const CoordinatePath corners{best->polyline, {}, false};
  if (problem.manifold->residual(corners) > kOff * best->length) {
    current.notes.emplace_back(
        "taut: the shortest path of the class, or the polyline around it, would leave the domain; the solved one "
        "stays");
    return current;
  }
  current.chain = std::move(chain);
  current.curve = {};
  current.curve.x = best->polyline;
  current.curve.cost = unit * best->length;
  current.curve.least_of_class = unit * best->least;
  current.curve.straightness = -unheld_turn(walls, best->polyline, monitor.deadline);
  return current;
}

}  // namespace leastcost
