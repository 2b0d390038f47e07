// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// The delivered curve: a polyline that lies on the domain.
struct Curve {
  Points x;                         ///< ambient, d x (m + 1)
  std::vector<Site> segment_sites;  ///< the piece (face) that carries each of the m segments; empty without sites
  double cost = 0;                  ///< its true cost: the sum of the segment costs
  /// Smallest angle beside an interior point minus pi, measured on the curve by a checker that shares nothing with the
  /// method that made it; set when the curve claims to be a locally shortest path of a polyhedron. Among obstacles:
  /// minus the largest turn at a point that no obstacle holds.
  std::optional<double> straightness = {};
  /// No path of its class costs less; set when the curve claims to be the shortest of its class but for what lies
  /// between.
  std::optional<double> least_of_class = {};
  /// What its cost is above that of the locally least path beside it, as measured; set when the curve claims to be that
  /// but for so much.
  std::optional<double> excess = {};
  /// What a proof over all paths says of the curve; none: none was tried.
  std::optional<GlobalBound> global = {};
};

/// The path after a step.
struct PostProcessed {
  Curve curve;                     ///< what is delivered
  CoordinatePath chain;            ///< the path's points on that curve, equally spaced in cost
  Eigen::VectorXd curve_costs;     ///< cost of the curve between consecutive points of the chain
  std::vector<std::string> notes;  ///< what the step says
  bool collapsed = false;          ///< a ring that contracts to a point: there is no closed curve to deliver
  bool unsolved = false;           ///< the chain is samples of the first path, which no solver has moved
  /// A path that costs less than the curve and is of another class, say: the search begins anew from it, once, and what
  /// costs less is delivered.
  std::optional<CoordinatePath> cheaper = {};
};

/// Turns a solved chain into a curve on the domain (VFCS 4.4.3). Applied in the order given; each sees what the one
/// before it made.
class PostProcessor {
 public:
  virtual ~PostProcessor() = default;
  virtual std::string_view name() const = 0;  ///< its name in configurations
  /// Whether it finds the way by itself, so that a chain which is not clear of obstacles is as good a beginning.
  virtual bool finds_its_own() const { return false; }
  /// Whether it bounds the cost of all paths (Curve::global).
  virtual bool bounds_all_paths() const { return false; }
  /// Takes the path a step further. Throws InitializationError, Interrupted.
  virtual PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                              const Monitor& monitor) const = 0;
};

}  // namespace leastcost
