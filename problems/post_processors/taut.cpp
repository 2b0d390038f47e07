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
#include "problems/obstacles/crossing_word.hpp"
#include "problems/taut/taut_path.hpp"
#include "problems/taut/tight_string.hpp"

namespace leastcost {
namespace {

constexpr double kLeastExcess = 1e-10;  ///< a full circle is then a polyline of 200,000 sides
constexpr double kMostExcess = 0.01;
constexpr double kOff = 1e-9;  ///< of the length: by so much a point may be off the domain

/// A path that is pulled tight, in the plane or in space.
struct Tight {
  Points polyline;
  double length = 0;  ///< of the polyline
  double least = 0;   ///< what it may come down to: in the plane no path of the class is shorter
};

const Walls& walls_of(const Problem& problem) {
  const ConstraintManifold& manifold = *problem.manifold;
  const auto* domain = find_ability<HasWalls>(manifold);
  const Dimensions d = manifold.dimensions();
  const bool flat = d.coordinate == d.ambient && d.tangent == d.ambient && find_ability<HasChart>(manifold) == nullptr;
  if (domain == nullptr || !flat || d.ambient < 2 || d.ambient > 3)
    throw InputError("taut needs the plane or space with obstacles in it");
  if (d.ambient == 2 && !domain->walls().rounds(Eigen::AlignedBox2d()))
    throw InputError("in the plane taut needs obstacles that are balls, boxes, polygons or maps");
  if (problem.ring) throw InputError("taut joins two ends, and this path is a ring");
  return domain->walls();
}

/// The cost of a move of length one, the same in all directions.
double cost_of_length(const Problem& problem) {
  const auto* cost = find_ability<HasConstantMetric>(*problem.cost);
  const Eigen::MatrixXd metric = cost != nullptr ? cost->metric() : Eigen::MatrixXd();
  if (metric.rows() != problem.source.u.size() ||
      !metric.isApprox(metric(0, 0) * Eigen::MatrixXd::Identity(metric.rows(), metric.cols())))
    throw InputError("taut needs a cost that is the length, or a multiple of it, in all directions");
  return std::sqrt(metric(0, 0));
}

std::optional<Tight> tight(const Walls& walls, const Points& start, double excess, const Monitor& monitor) {
  if (walls.dimension() == 3) {
    auto string = tight_string(walls, start, excess, monitor);
    if (!string) return std::nullopt;
    return Tight{std::move(string->polyline), string->length, string->length - string->excess};
  }
  auto path = taut_path(walls, start, excess, monitor.deadline);
  if (!path) return std::nullopt;
  return Tight{std::move(path->polyline), path->length, path->least};
}

/// `columns` points of a polyline, equally spaced by length, and the lengths between them.
Points spaced_by_length(const Points& polyline, Index columns, Eigen::VectorXd& lengths) {
  Eigen::VectorXd reached(polyline.cols());
  reached[0] = 0;
  for (Index i = 1; i < polyline.cols(); ++i)
    reached[i] = reached[i - 1] + (polyline.col(i) - polyline.col(i - 1)).norm();
  const double total = reached[reached.size() - 1];
  Points points(polyline.rows(), columns);
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

std::optional<Tight> shorter(std::optional<Tight> a, std::optional<Tight> b) {
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
  const Walls& walls = walls_of(problem);
  const double unit = cost_of_length(problem);
  const bool plane = walls.dimension() == 2;
  std::optional<Tight> best = tight(walls, first.path.u, options_.excess, monitor);
  if (!best || !plane || !of_one_class(walls, first.path.u, current.chain.u).value_or(false))
    best = shorter(std::move(best), tight(walls, current.chain.u, options_.excess, monitor));
  if (!best) {
    current.notes.emplace_back(
        "taut: neither the first path nor the solved one could be pulled tight; it stays (in space obstacles must be "
        "convex)");
    return current;
  }
  CoordinatePath chain = current.chain;
  chain.u = spaced_by_length(best->polyline, chain.u.cols(), current.curve_costs);
  current.curve_costs *= unit;
  const CoordinatePath corners{best->polyline, {}, false};
  if (problem.manifold->residual(corners) > kOff * best->length) {
    current.notes.emplace_back(
        "taut: the path pulled tight, or the polyline around it, would leave the domain; the solved one stays");
    return current;
  }
  current.chain = std::move(chain);
  current.curve = {};
  current.curve.x = best->polyline;
  current.curve.cost = unit * best->length;
  if (plane) {
    current.curve.least_of_class = unit * best->least;
    current.curve.straightness = -unheld_turn(walls, best->polyline, monitor.deadline);
  } else {
    current.curve.excess = unit * (best->length - best->least);
    current.curve.straightness = -unheld_bends(walls, best->polyline).largest;
  }
  return current;
}

}  // namespace leastcost
