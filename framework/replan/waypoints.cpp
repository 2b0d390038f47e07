// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/replan/waypoints.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/problem/clearance.hpp>

namespace leastcost {
namespace {

constexpr double kMostWaypoints = 1e7;
/// Of a spacing: what is left of the path is no move of its own. Of the size of a path: it does not touch.
constexpr double kNegligible = 1e-9;

/// The delivered curve as an open polyline in coordinates: a ring ends at its first point again.
CoordinatePath polyline_of(const Problem& problem, const Result& result) {
  CoordinatePath line;
  if (find_ability<HasChart>(*problem.manifold) == nullptr) {
    line.u = result.curve.x;
    line.sites = result.curve.segment_sites;
    if (!line.sites.empty()) line.sites.push_back(line.sites.back());
    return line;
  }
  line.u.resize(result.path.u.rows(), result.path.segment_count() + 1);
  for (Index i = 0; i < line.u.cols(); ++i) line.u.col(i) = result.path.column(i);
  return line;
}

Eigen::VectorXd costs_of(const Problem& problem, const Points& x) {
  return segment_costs(*problem.cost, {{x.data(), x.rows(), x.cols()}, {}, false});
}

/// Points on a polyline by the cost from its beginning.
class ByCost {
 public:
  ByCost(const Problem& problem, CoordinatePath line) : problem_(problem), line_(std::move(line)) {
    const Eigen::VectorXd costs = costs_of(problem, positions(*problem.manifold, line_));
    cumulative_ = Eigen::VectorXd::Zero(costs.size() + 1);
    for (Index i = 0; i < costs.size(); ++i) cumulative_[i + 1] = cumulative_[i] + costs[i];
  }

  double total() const { return cumulative_[cumulative_.size() - 1]; }
  bool has_sites() const { return !line_.sites.empty(); }

  /// The point where `cost` is spent.
  CoordinatePath at(double cost) const {
    const double* begin = cumulative_.data();
    const Index i = std::clamp<Index>(std::upper_bound(begin, begin + cumulative_.size(), cost) - begin - 1, 0,
                                      cumulative_.size() - 2);
    const double whole = cumulative_[i + 1] - cumulative_[i];
    return part_of(i, whole > 0 ? std::clamp((cost - cumulative_[i]) / whole, 0.0, 1.0) : 0);
  }

 private:
  CoordinatePath between(Index segment, double t) const {
    CoordinatePath point{(1 - t) * line_.u.col(segment) + t * line_.u.col(segment + 1), {}, true};
    if (has_sites()) point.sites = {line_.site(segment)};
    if (t <= 0 || t >= 1) return point;
    CoordinatePath placed = point;
    return problem_.manifold->project(placed).failed.empty() ? placed : point;
  }

  /// What of the cost of a move is spent at t along it.
  double share_at(Index segment, const CoordinatePath& point) const {
    CoordinatePath way{Points(line_.u.rows(), 3), {}, false};
    way.u << line_.u.col(segment), point.u, line_.u.col(segment + 1);
    const Eigen::VectorXd costs = costs_of(problem_, positions(*problem_.manifold, way));
    return costs[0] / costs.sum();
  }

  /// The point of a move at a share of its cost: a false position in a bracket (Illinois), from the share of its
  /// length, which is the same where the cost is a distance.
  CoordinatePath part_of(Index segment, double share) const {
    constexpr int kMostTrials = 60;
    constexpr double kNear = 1e-12;
    double low = 0, high = 1, below = -share, above = 1 - share, t = share;
    CoordinatePath point = between(segment, t);
    for (int trial = 0; trial < kMostTrials && t > 0 && t < 1; ++trial) {
      const double off = share_at(segment, point) - share;
      if (!std::isfinite(off)) return between(segment, share);
      if (std::abs(off) <= kNear) break;
      const bool over = off > 0;
      if (over) {
        high = t, above = off, below /= 2;
      } else {
        low = t, below = off, above /= 2;
      }
      t = low + (high - low) * below / (below - above);
      point = between(segment, t);
    }
    return point;
  }

  const Problem& problem_;
  CoordinatePath line_;
  Eigen::VectorXd cumulative_;
};

/// Costs at which the points are, from 0 on.
Eigen::VectorXd costs_asked(const WaypointOptions& options, double total, bool ring) {
  const int fewest = ring ? 3 : 2;
  if (options.count.has_value() == options.spacing.has_value())
    throw OptionError("count", "waypoints need either a count or a spacing, not both");
  if (options.count) {
    if (*options.count < fewest) throw OptionError("count", "must be at least " + std::to_string(fewest));
    const Index moves = ring ? *options.count : *options.count - 1;
    return Eigen::VectorXd::LinSpaced(moves + 1, 0, total).head(*options.count);
  }
  const double spacing = *options.spacing;
  if (!(spacing > 0)) throw OptionError("spacing", "must be greater than 0");
  if (total / spacing > kMostWaypoints)
    throw OptionError("spacing", "would make more than ten million waypoints: give a larger spacing");
  const Index moves = std::max<Index>(1, static_cast<Index>(std::ceil(total / spacing - kNegligible)));
  Eigen::VectorXd costs(ring ? moves : moves + 1);
  for (Index i = 0; i < moves; ++i) costs[i] = spacing * static_cast<double>(i);
  if (!ring) costs[moves] = total;
  return costs;
}

/// By how much the straight moves between the points differ from the path in cost.
std::optional<double> gap_of(const Problem& problem, const Waypoints& points) {
  Points closed = points.x;
  if (points.path.ring) {
    closed.conservativeResize(Eigen::NoChange, closed.cols() + 1);
    const CoordinatePath last{points.path.column(points.path.u.cols()), {}, true};
    closed.rightCols(1) = positions(*problem.manifold, last);
  }
  const double cost = costs_of(problem, closed).sum();
  return std::isfinite(cost) ? std::optional(cost - points.total) : std::nullopt;
}

}  // namespace

void WaypointOptions::fields(FieldVisitor& visit) {
  visit.field("count", count,
              {.help = "Exact number of waypoints, including the ends.", .minimum = 2, .maximum = kMostWaypoints});
  visit.field("spacing", spacing,
              {.help = "Cost between waypoints; the last move has the remainder.",
               .unit = "cost",
               .minimum = 0,
               .exclusive_minimum = true});
}

Waypoints place_waypoints(const Problem& problem, const Result& result, const WaypointOptions& options,
                          const Deadline& deadline) {
  constexpr Index kAtOnce = 16;  // between two looks at the clock
  if (result.curve.x.cols() < 2) throw InputError("waypoints: there is no path to place them on");
  const ByCost curve(problem, polyline_of(problem, result));
  Waypoints out;
  out.total = curve.total();
  if (!(out.total > 0) || !std::isfinite(out.total)) throw InputError("waypoints: the path has no finite cost above 0");
  const bool ring = result.path.ring;
  out.cost = costs_asked(options, out.total, ring);
  out.path = {Points(result.path.u.rows(), out.cost.size()), {}, ring, result.path.closing};
  for (Index i = 0; i < out.cost.size(); ++i) {
    if (i % kAtOnce == 0) look_at_clock(deadline);
    const CoordinatePath point = curve.at(out.cost[i]);
    out.path.u.col(i) = point.u;
    if (curve.has_sites()) out.path.sites.push_back(point.sites.front());
  }
  out.x = positions(*problem.manifold, out.path);
  out.gap = gap_of(problem, out);
  out.clearance = measure_clearance(*problem.manifold, out.x, ring, deadline);
  out.touches = out.clearance && out.clearance->lower < -contact_tolerance(out.x, kNegligible);
  return out;
}

}  // namespace leastcost
