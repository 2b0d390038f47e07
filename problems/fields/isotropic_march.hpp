// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "problems/graph/bucket_queue.hpp"

namespace leastcost {

/// The least cost from some sources to each node of a lattice in the plane, for a cost of n(x) times length: |grad u| =
/// n by Dijkstra's order over the eight triangles around a node. A node also keeps its gradient, which is n times the
/// direction of arrival, so that u along an edge is a cubic and the field has second order (jet marching: Potter,
/// Cameron, J. Sci. Comput. 88, 2021). Where the gradients at the ends of an edge belong to two fronts, u is linear.
///
/// A move over an edge costs more than either of its ends by a part of the least n, so that nodes whose costs are
/// nearer to each other than that do not depend on each other: they become final together (BucketQueue).
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
  /// One bit each in a byte of its own, so that those of eight neighbours fit into one number.
  enum State : std::uint32_t { kOpen = 0, kFinal = 1, kBlocked = 1U << 8, kInBatch = 1U << 16 };
  struct Node {
    double u;
    float px, py;   ///< the last move; the gradient once the node is final
    float density;  ///< infinite: blocked, as the frame around the lattice is
    std::uint32_t state;
  };
  /// A node of the ring around one that has just become final, and an edge of its own ring between that one and
  /// another.
  struct Triangle {
    std::int32_t node, near, far, fourth;  ///< from the final one; `near` is beside the node, `far` diagonal to it
    double off, edge;                      ///< from the node to `near`, and from there to `far`: signed, length units
    bool off_x;                            ///< the former is along x, the latter along y
  };
  /// An edge that a least-cost move to a node crosses: u(near), what u is along it, n on a move, and slopes at its
  /// ends.
  struct Crossing {
    double u, rise, curve_near, curve_far, n, dn, first, last;
    std::int32_t node;
    std::uint32_t triangle;
  };
  struct Direct {
    double u;
    std::int32_t node;
    std::uint32_t ring;
  };
  struct Work;
  struct Offer {
    double u;
    double x, y;  ///< from the node to where the last move begins
  };

  std::int32_t number(std::int32_t i, std::int32_t j) const { return (j + 1) * width_ + i + 1; }
  Eigen::Vector2d place(std::int32_t node) const;
  void lay_triangles();
  double bucket_width() const;
  void accept(std::vector<std::int32_t>& batch);
  void leave(std::int32_t node, Work& work);
  void find_crossings(const Node& from, std::int32_t number, std::uint32_t triangles, Work& work) const;
  void find_directs(const Node& from, std::int32_t number, std::uint32_t directions, Work& work) const;
  Offer over(const Crossing& crossing) const;
  void take(std::int32_t node, const Offer& offer, BucketQueue<std::int32_t>& queue);
  void finish(std::int32_t node);

  Lattice lattice_;
  Passes passes_;
  bool passes_corners_ = false;
  std::int32_t width_;
  std::array<std::int32_t, 8> ring_{};      ///< to the neighbours, counter-clockwise
  std::array<Eigen::Vector2d, 8> moves_{};  ///< the same in length units
  std::array<double, 8> lengths_{};
  std::array<Triangle, 16> triangles_{};  ///< those with the next node of the ring, then those with the one before
  std::vector<Node> nodes_;               ///< in a frame of one node
  std::vector<std::int32_t> started_;
};

}  // namespace leastcost
