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

/// What moves into a node of a lattice cost by the line element there, from the eight nodes around it and from places
/// between them, which divide each edge of the ring into equal parts. The line element is asked once per node where it
/// is the same in all directions, a few times where it is a metric, else once per place.
class NodeMoves {
 public:
  static constexpr std::size_t kMostParts = 16;

  /// `u`: coordinates of the nodes, 2 x m. `step`: from node to node.
  NodeMoves(const Problem& problem, const Eigen::Matrix2Xd& u, const Eigen::Vector2d& step);

  /// Parts of an edge: two are exact for a metric, whose square is a parabola along an edge; sixteen where a wind or a
  /// slope makes the cost fall steeply within a few degrees.
  std::size_t parts() const { return parts_; }
  std::size_t directions() const { return kRing.size() * parts_; }
  /// Direction parts() k comes from node k of the ring, those after it from the places between it and the next.
  double cost(std::int32_t node, std::size_t direction) const {
    const auto n = static_cast<std::size_t>(node);
    return isotropic() ? scales_[n] * lengths_[direction] : static_cast<double>(tables_[n * directions() + direction]);
  }
  /// The cost of a unit of length is the same in all directions: the order of arrivals is then that of their costs.
  bool isotropic() const { return !scales_.empty(); }
  /// The least cost of the directions between neighbour k of the ring and the next, and of one beside them at each end,
  /// of a cost that is asked in every direction; infinite where there is none.
  double least(std::int32_t node, std::size_t k) const {
    return static_cast<double>(least_[static_cast<std::size_t>(node) * kRing.size() + k]);
  }
  /// No move leads there.
  bool blocked(std::int32_t node) const { return blocked_[static_cast<std::size_t>(node)] != 0; }
  void block(std::int32_t node) { blocked_[static_cast<std::size_t>(node)] = 1; }
  /// Some node is blocked.
  bool any_blocked() const { return any_blocked_; }
  /// Some node is left in some directions only, as where a current outruns the vehicle.
  bool any_carried() const { return any_carried_; }

 private:
  void divide(std::size_t parts, const Eigen::Vector2d& step);
  bool ask_densities(const Problem& problem, const Eigen::Matrix2Xd& u);
  /// False: the line element of some node comes from no metric.
  bool ask_elements(const Problem& problem, const Eigen::Matrix2Xd& u);
  void ask_all_elements(const Problem& problem, const Eigen::Matrix2Xd& u);

  static constexpr std::size_t kOfMetric = 2, kOfOthers = kMostParts;

  std::size_t parts_ = kOfMetric;
  std::vector<Eigen::Vector2d> moves_;  ///< per direction
  std::vector<double> lengths_;
  std::vector<double> scales_;  ///< cost of a unit of length, where it is the same in all directions
  std::vector<float> tables_;   ///< of other costs: the directions of a node after those of the one before
  std::vector<float> least_;    ///< of costs that are asked in every direction: see least()
  std::vector<unsigned char> blocked_;
  bool any_blocked_ = false, any_carried_ = false;
};

}  // namespace leastcost
