// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/post_processors/plan_curve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include "problems/taut/taut_path.hpp"
#include "problems/taut/unheld_bends.hpp"

namespace leastcost {
namespace {

constexpr double kOff = 1e-9;  ///< of the length: by so much a point may be off the domain

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

std::string why_no_walls(const Problem& problem) {
  const ConstraintManifold& manifold = *problem.manifold;
  const auto* domain = find_ability<HasWalls>(manifold);
  const Dimensions d = manifold.dimensions();
  const bool flat = d.coordinate == d.ambient && d.tangent == d.ambient && find_ability<HasChart>(manifold) == nullptr;
  if (domain == nullptr || !flat || d.ambient < 2 || d.ambient > 3) return "needs the plane or space with obstacles";
  if (d.ambient == 2 && find_ability<HasRounds>(domain->walls()) == nullptr)
    return "in the plane needs obstacles that are balls, boxes, polygons or maps";
  if (problem.ring) return "joins two ends, but this path is a ring";
  return "";
}

/// The cost of a move of length one, the same in all directions; nothing where it is not.
std::optional<double> unit_of_length(const Problem& problem) {
  const auto* cost = find_ability<HasConstantMetric>(*problem.cost);
  const Eigen::MatrixXd metric = cost != nullptr ? cost->metric() : Eigen::MatrixXd();
  if (metric.rows() != problem.manifold->dimensions().ambient ||
      !metric.isApprox(metric(0, 0) * Eigen::MatrixXd::Identity(metric.rows(), metric.cols())))
    return std::nullopt;
  return std::sqrt(metric(0, 0));
}

constexpr const char* kNeedsLength = "needs a cost that is the length or a multiple of it";

}  // namespace

std::string why_no_tight_path(const Problem& problem) {
  const std::string why = why_no_walls(problem);
  return !why.empty() || unit_of_length(problem) ? why : kNeedsLength;
}

const Walls& walls_of(const Problem& problem, const std::string& who) {
  if (const std::string why = why_no_walls(problem); !why.empty()) throw InputError(who + " " + why);
  return find_ability<HasWalls>(*problem.manifold)->walls();
}

double cost_of_length(const Problem& problem, const std::string& who) {
  const std::optional<double> unit = unit_of_length(problem);
  if (!unit) throw InputError(who + " " + kNeedsLength);
  return *unit;
}

bool deliver_plan(const Problem& problem, const Walls& walls, double unit, const TightPath& path,
                  const Monitor& monitor, PostProcessed& current) {
  if (problem.manifold->residual({path.polyline, {}, false}) > kOff * path.length) return false;
  current.chain.u = spaced_by_length(path.polyline, current.chain.u.cols(), current.curve_costs);
  current.curve_costs *= unit;
  current.curve = {};
  current.curve.x = path.polyline;
  current.curve.cost = unit * path.length;
  if (walls.dimension() == 2) {
    current.curve.least_of_class = unit * path.least;
    current.curve.straightness = -unheld_turn(walls, path.polyline, monitor.deadline);
  } else {
    current.curve.excess = unit * (path.length - path.least);
    current.curve.straightness = -unheld_bends(walls, path.polyline, monitor.deadline).largest;
  }
  return true;
}

}  // namespace leastcost
