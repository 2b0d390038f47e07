// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/chart/seams.hpp>

namespace leastcost {

/// Least costs between the nearest of some places and every node of a regular lattice in two coordinates.
struct CostField {
  std::array<std::int32_t, 2> count = {0, 0};       ///< nodes along x and y
  Eigen::Vector2d lower = Eigen::Vector2d::Zero();  ///< of node (0, 0), coordinate
  Eigen::Vector2d step = Eigen::Vector2d::Ones();   ///< from node to node
  std::vector<double> values;                       ///< row by row, the lowest y first; NaN: no path
  std::vector<Eigen::VectorXd> places;              ///< the costs are from, or to, the nearest of these; coordinates
  std::vector<SeamMap> poles;                       ///< beyond which a place has another name
  std::vector<Seam> seams;  ///< across which the lattice closes on itself: its ends are the same
  bool to_places = false;   ///< costs of the way to them, not from them
  bool directed = false;    ///< there and back may differ
  /// The largest ratio of the costs of a short move and of the same move back, at a sample of the nodes. Beyond
  /// kFaithfulAsymmetry values can be wrong by more than `error`: the lattice has too few directions for the narrow
  /// cone in which moves are cheap.
  double asymmetry = 1;
  static constexpr double kFaithfulAsymmetry = 100;  ///< measured in constant winds up to 0.98 of the speed
  std::string method;                                ///< "isotropic march" or "arrival field"
  /// An estimate of the error, not a bound: three times the largest and the mean difference, at common nodes, from the
  /// field on half as many cells; four times among obstacles and of an arrival field; of several places also a part of
  /// the bend where their fronts meet. NaN where it was not asked for or there are too few nodes. Cost units.
  double error = std::numeric_limits<double>::quiet_NaN();
  double mean_error = std::numeric_limits<double>::quiet_NaN();  ///< see `error`
  /// Why some nodes have no value that no obstacle keeps out: their cost is not positive or not finite. In words, with
  /// one of the places; empty where there are none.
  std::string without_cost;
  std::size_t free_nodes = 0;                         ///< at which a unit of length costs nothing
  Eigen::Vector2d free_at = Eigen::Vector2d::Zero();  ///< the first of them, coordinates
  bool enclosed = false;  ///< no node farther than a few steps from the places is reached, though there are some
  /// How far the box goes on beyond the last nodes, coordinates: more than a rounding error with equal steps only.
  Eigen::Vector2d uncovered = Eigen::Vector2d::Zero();
  std::size_t unresolved = 0;  ///< nodes that only the finer of the two fields reaches: passages of one or two cells

  /// The coordinates of node (i, j).
  Eigen::Vector2d node(std::int32_t i, std::int32_t j) const {
    return lower + step.cwiseProduct(Eigen::Vector2d(i, j));
  }
  /// Of node (i, j); NaN: no path.
  double value(std::int32_t i, std::int32_t j) const {
    return values[static_cast<std::size_t>(j) * static_cast<std::size_t>(count[0]) + static_cast<std::size_t>(i)];
  }
};

/// How a field is computed.
struct CostFieldOptions {
  /// From node to node, length units, at most: the box is covered to its edges. None: a node on every value (or cell)
  /// of a raster of costs; elsewhere a 200th of the longest side.
  std::optional<double> resolution = {};
  bool equal_steps = false;    ///< along x and y, even if a strip at the upper edges has no nodes then
  bool to_places = false;      ///< the costs of ways to the places, not from them
  bool estimate_error = true;  ///< takes a quarter longer, with a cost that depends on direction too
};

/// The least cost from the nearest of some places (coordinates; at least one) to every node, under the cost of a
/// problem, in its domain and among its obstacles. The box is that of the domain, else that of a raster of costs, else
/// one around the ends of the problem with their distance as margin; a problem's ends have no other part in it. A chart
/// that closes on itself has one period along its seams, and fields cross them. Where a
/// unit of length costs the same in all directions the field is by IsotropicMarch, elsewhere by the line elements at
/// the nodes (ArrivalField). Both are of second order where the cost is smooth, and of first order beside obstacles and
/// at kinks of the cost. Throws InputError for rings, for domains without two coordinates and for angles of
/// joints, for places outside and those that no path leaves; OptionError ("resolution"), also for one that leaves
/// fewer than four cells along a side; Interrupted.
CostField costs_from(const Problem& problem, const std::vector<Eigen::VectorXd>& places,
                     const CostFieldOptions& options = {}, const Monitor& monitor = {});

/// How much dearer than the cheapest way a detour through each node is: the sum of two fields, from some places and to
/// others, less its least value. `known`: what the cheapest way costs at most; places that are near each other have it
/// between the nodes, and their least value is then too large. Throws InputError where the lattices differ, NoWay where
/// no node has a way to both.
CostField corridor(const CostField& from, const CostField& to, double known = std::numeric_limits<double>::infinity());

/// The way between a place and the nearest of the field's places, down the field: coordinates, in the order in which it
/// is walked. Its cost exceeds the least by about the error of the field; improve_path() makes it a certified path.
/// Throws InputError where the place is outside the field or has no way.
std::vector<Eigen::Vector2d> way_down(const CostField& field, const Problem& problem, const Eigen::Vector2d& place);

/// The value of a field at a place, linear between nodes; NaN where one of those that count has none.
double value_at(const CostField& field, const Eigen::Vector2d& place);

/// What a way costs under the cost of a problem, each move in pieces.
double cost_of_way(const Problem& problem, const std::vector<Eigen::Vector2d>& way);

}  // namespace leastcost
