// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// The nodes around a node, counter-clockwise: neighbours in the list are those of an edge.
inline constexpr std::array<std::array<std::int32_t, 2>, 8> kRing = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// What moves into a node of a lattice cost by the line element there, from the eight nodes around it and the middles
/// between them. The line element is asked once per node where it is the same in all directions, a few times where it
/// is a metric, else once per direction.
class NodeMoves {
 public:
  /// Direction 2 k comes from node k of the ring, 2 k + 1 from the middle between it and the next.
  static constexpr std::size_t kDirections = 2 * kRing.size();

  /// `u`: coordinates of the nodes, 2 x m. `step`: from node to node.
  NodeMoves(const Problem& problem, const Eigen::Matrix2Xd& u, const Eigen::Vector2d& step);

  double cost(std::int32_t node, std::size_t direction) const {
    const auto n = static_cast<std::size_t>(node);
    return tables_.empty() ? scales_[n] * lengths_[direction] : static_cast<double>(tables_[n][direction]);
  }
  /// The cost of a unit of length is the same in all directions: the order of arrivals is then that of their costs.
  bool isotropic() const { return tables_.empty(); }
  /// No move leads there.
  bool blocked(std::int32_t node) const { return blocked_[static_cast<std::size_t>(node)] != 0; }
  void block(std::int32_t node) { blocked_[static_cast<std::size_t>(node)] = 1; }
  /// Some node is blocked.
  bool any_blocked() const { return any_blocked_; }
  /// Some node is left in some directions only, as where a current outruns the vehicle.
  bool any_carried() const { return any_carried_; }

 private:
  using Table = std::array<float, kDirections>;

  bool ask_densities(const Problem& problem, const Eigen::Matrix2Xd& u);
  void ask_elements(const Problem& problem, const Eigen::Matrix2Xd& u);

  std::array<Eigen::Vector2d, kDirections> moves_;
  std::array<double, kDirections> lengths_{};
  std::vector<double> scales_;  ///< cost of a unit of length, where it is the same in all directions
  std::vector<Table> tables_;   ///< of other costs
  std::vector<unsigned char> blocked_;
  bool any_blocked_ = false, any_carried_ = false;
};

}  // namespace leastcost
