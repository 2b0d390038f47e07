// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace leastcost {

/// The least cost from some sources to each node of a lattice in space, for a cost of n(x) times length: |grad u| = n
/// by Dijkstra's order over the 48 triangles around a node (the 26 nodes around it are the corners of the triangles).
/// As IsotropicMarch does in the plane, a node also keeps its gradient. Over a triangle with corners x_i
///
///     u(p) = sum of l_i (u_i + grad u_i . (p - x_i) / 2),   l_i the barycentric coordinates of p,
///
/// which is exact for quadratic u, so that the field is of second order; u is linear where the gradients at the corners
/// belong to several fronts.
class SpaceMarch {
 public:
  using Vector = Eigen::Vector3d;
  /// Whether obstacles let the straight move between two places pass, in coordinates; empty: always.
  using Passes = std::function<bool(const Vector&, const Vector&)>;
  struct Lattice {
    Vector lower, step;                 ///< of node (0, 0, 0), and from node to node, length units
    std::array<std::int32_t, 3> count;  ///< nodes along x, y and z
    Vector place(std::int32_t i, std::int32_t j, std::int32_t k) const {
      return lower + step.cwiseProduct(Vector(i, j, k));
    }
  };

  /// `densities`: n at the nodes, x fastest; not finite or below 0: no path comes there.
  SpaceMarch(const Lattice& lattice, const std::vector<double>& densities, Passes passes);

  /// Lets paths leave a place straight for the nodes within a few steps; `cost` of such a move, infinite for none.
  void start(const Vector& source, const std::function<double(const Vector&, const Vector&)>& cost);
  /// Fills the field. `stop` is asked now and then. Throws Interrupted.
  void run(const std::function<bool()>& stop);
  /// x fastest; infinite where nothing arrives.
  std::vector<double> values() const;

 private:
  struct Node {
    double u;
    std::array<float, 3> p;  ///< unit vector of arrival; the gradient once the node is final
    float density;           ///< infinite: blocked, as the frame around the lattice is
    float length;            ///< of the last move
  };
  /// From the node to where the last move begins, and what it costs.
  struct Offer {
    double u;
    Vector from;
  };
  /// Corners of a triangle of the ring, or of one of its edges, in the order axis, edge, corner of the cube: legs[i]
  /// leads from the corner before to corner i, at right angles to the others; legs[0] from the node, perpendicular to
  /// the triangle. Of an edge `corners` is 2.
  struct Side {
    int corners;
    std::array<std::int32_t, 3> node;  ///< numbers relative to that of the node
    std::array<Vector, 3> at;          ///< relative to the node
    double apart;                      ///< of the node from the first corner, which is the foot of its perpendicular
    std::array<double, 2> legs;        ///< from corner to corner
  };

  std::int32_t number(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return i + 1 + width_ * (j + 1 + height_ * (k + 1));
  }
  Vector place(std::int32_t node) const;
  void list_sides();
  const Node& node(std::int32_t number) const { return nodes_[static_cast<std::size_t>(number)]; }
  /// Over the inside of a triangle or an edge, whose corners are final; false: no least cost is there.
  bool inside(const Node& here, const Side& side, std::int32_t number, Offer& offer) const;
  static void refine(const Node& here, const Side& side, const std::array<const Node*, 3>& corner,
                     std::array<double, 3>& share);
  bool take(std::int32_t number, const Offer& offer);
  void finish(std::int32_t number);
  /// Offers the node what comes through its neighbour `by`, number k of its ring.
  bool improve(std::int32_t number, std::int32_t by, std::size_t k);

  Lattice lattice_;
  Passes passes_;
  std::int32_t width_, height_;  ///< of the frame
  std::array<std::int32_t, 26> ring_{};
  std::array<Vector, 26> moves_;
  std::array<std::vector<Side>, 26> sides_;  ///< with that node of the ring among their corners
  std::vector<Node> nodes_;                  ///< in a frame of one node
  std::vector<unsigned char> final_;
  std::vector<std::int32_t> started_;
};

}  // namespace leastcost
