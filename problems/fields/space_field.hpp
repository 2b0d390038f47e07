// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/fields/cost_field.hpp>

namespace leastcost {

/// Least costs between the nearest of some places and every node of a regular lattice in space. As CostField is in two
/// coordinates.
struct SpaceField {
  std::array<std::int32_t, 3> count = {0, 0, 0};    ///< nodes along x, y and z
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();  ///< of node (0, 0, 0), coordinate
  Eigen::Vector3d step = Eigen::Vector3d::Ones();   ///< from node to node
  std::vector<double> values;                       ///< x fastest, then y; NaN: no path
  std::vector<Eigen::VectorXd> places;              ///< the costs are from, or to, the nearest of these; coordinates
  bool to_places = false;                           ///< ways are walked to them
  bool directed = false;                            ///< there and back may differ
  std::string method;                               ///< "isotropic march" or "arrival field"
  double error = std::numeric_limits<double>::quiet_NaN();       ///< as CostField::error
  double mean_error = std::numeric_limits<double>::quiet_NaN();  ///< as CostField::mean_error
  std::size_t unresolved = 0;                                    ///< as CostField::unresolved
  std::string without_cost;                                      ///< as CostField::without_cost
  std::size_t free_nodes = 0;                                    ///< as CostField::free_nodes
  Eigen::Vector3d free_at = Eigen::Vector3d::Zero();             ///< as CostField::free_at
  bool enclosed = false;                                         ///< as CostField::enclosed

  /// The coordinates of node (i, j, k).
  Eigen::Vector3d node(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return lower + step.cwiseProduct(Eigen::Vector3d(i, j, k));
  }
  /// Of node (i, j, k); NaN: no path.
  double value(std::int32_t i, std::int32_t j, std::int32_t k) const {
    const auto row = static_cast<std::size_t>(k) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(j);
    return values[row * static_cast<std::size_t>(count[0]) + static_cast<std::size_t>(i)];
  }
};

/// Whether a problem is one of space_costs_from(): its domain is space or a box of it, perhaps with obstacles.
bool is_in_space(const Problem& problem);

/// The least cost from the nearest of some places (at least one) to every node, in a box of space and among its
/// obstacles, for costs that are the same in all directions (SpaceMarch), metrics and the time in winds weaker than the
/// speed (SpaceArrival). Without a resolution the longest side has 80 steps, 40 if the direction counts. The box is
/// found as in costs_from(). Throws InputError for other domains and costs, for places outside and those that no path
/// leaves; OptionError ("resolution"); Interrupted.
SpaceField space_costs_from(const Problem& problem, const std::vector<Eigen::VectorXd>& places,
                            const CostFieldOptions& options = {}, const Monitor& monitor = {});

/// As for two fields in two coordinates.
SpaceField corridor(const SpaceField& from, const SpaceField& to,
                    double known = std::numeric_limits<double>::infinity());

/// As for a field in two coordinates.
std::vector<Eigen::Vector3d> way_down(const SpaceField& field, const Problem& problem, const Eigen::Vector3d& place);

/// What a way costs under the cost of a problem, each move in pieces.
double cost_of_way(const Problem& problem, const std::vector<Eigen::Vector3d>& way);

}  // namespace leastcost
