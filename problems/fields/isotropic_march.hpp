// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace leastcost {

/// The least cost from some sources to each node of a lattice in the plane, for a cost of n(x) times length: |grad u| =
/// n by Dijkstra's order over the eight triangles around a node. A node also keeps its gradient, which is n times the
/// direction of arrival, so that u along an edge is a cubic and the field has second order (jet marching: Potter,
/// Cameron, J. Sci. Comput. 88, 2021). Where the gradients at the ends of an edge belong to two fronts, u is linear.
class IsotropicMarch {
 public:
  /// Whether obstacles let the straight move between two places pass, in coordinates; empty: always.
  using Passes = std::function<bool(const Eigen::Vector2d&, const Eigen::Vector2d&)>;
  struct Lattice {
    Eigen::Vector2d lower, step;        ///< of node (0, 0), and from node to node, length units
    std::array<std::int32_t, 2> count;  ///< nodes along x and y
    Eigen::Vector2d place(std::int32_t i, std::int32_t j) const {
      return lower + step.cwiseProduct(Eigen::Vector2d(i, j));
    }
  };

  /// `densities`: n at the nodes, row by row; not finite or below 0: no path comes there.
  IsotropicMarch(const Lattice& lattice, const std::vector<double>& densities, Passes passes);

  /// Lets paths pass the corner between two nodes when one beside it has no density, or both: the nodes are cells that
  /// are constant each, and the corner is part of those that it joins.
  void pass_corners() { passes_corners_ = true; }
  /// Lets paths leave a place straight for the nodes within a few steps; `cost` of such a move, infinite for none.
  void start(const Eigen::Vector2d& source,
             const std::function<double(const Eigen::Vector2d&, const Eigen::Vector2d&)>& cost);
  /// Fills the field. `stop` is asked now and then. Throws Interrupted.
  void run(const std::function<bool()>& stop);
  /// Row by row; infinite where nothing arrives.
  std::vector<double> values() const;

 private:
  struct Node {
    double u;
    float px, py;        ///< the last move; the gradient once the node is final
    float density;       ///< infinite: blocked, as the frame around the lattice is
    std::int32_t final;  ///< 1: so it is, or blocked
  };
  struct Offer {
    double u;
    double x, y;  ///< from the node to where the last move begins
  };

  std::int32_t number(std::int32_t i, std::int32_t j) const { return (j + 1) * width_ + i + 1; }
  Eigen::Vector2d place(std::int32_t node) const;
  /// Over the edge between an axis neighbour and a diagonal one, both final; false: no least cost inside the edge.
  bool inside_edge(const Node& node, std::size_t axis, std::int32_t near, std::int32_t far, double fourth,
                   Offer& offer) const;
  bool take(std::int32_t node, const Offer& offer);
  void finish(std::int32_t node);

  Lattice lattice_;
  Passes passes_;
  bool passes_corners_ = false;
  std::int32_t width_;
  std::array<std::int32_t, 8> ring_{};      ///< to the neighbours, counter-clockwise
  std::array<Eigen::Vector2d, 8> moves_{};  ///< the same in length units
  std::array<double, 8> lengths_{};
  std::vector<Node> nodes_;  ///< in a frame of one node
  std::vector<std::int32_t> started_;
};

}  // namespace leastcost
