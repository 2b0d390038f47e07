// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "problems/fields/drift_metric.hpp"
#include "problems/fields/space_march.hpp"

namespace leastcost {

/// The least cost from some sources to each node of a lattice in space, for a cost that depends on the direction: as
/// ArrivalField does in the plane, by the local variational principle over the 48 triangles around a node,
///
///     u(x) = min over the triangles around x and their points p of u(p) + (F(x, x - p) + F(p, x - p)) / 2,
///
/// F the line elements at the nodes. Nodes are worked off in the order of their costs, and again when they become
/// cheaper. Then sweeps with the gradients at the nodes (u(p) as in SpaceMarch) give second order where F is smooth.
class SpaceArrival {
 public:
  using Vector = Eigen::Vector3d;
  using Lattice = SpaceMarch::Lattice;
  using Passes = SpaceMarch::Passes;

  /// `elements`: at the nodes, x fastest.
  SpaceArrival(const Lattice& lattice, const std::vector<DriftMetric>& elements, Passes passes);

  /// As in SpaceMarch.
  void start(const Vector& source, const std::function<double(const Vector&, const Vector&)>& cost);
  /// Fills the field. `stop` is asked now and then. Throws Interrupted.
  void run(const std::function<bool()>& stop);
  /// x fastest; infinite where nothing arrives.
  std::vector<double> values() const;

 private:
  struct Node {
    double u;
    DriftMetric element;
    std::array<float, 3> gradient;  ///< of u
  };
  /// The last move to a node, and what u is with it.
  struct Offer {
    double u;
    Vector move;
  };
  /// A triangle of the ring, one of its edges or nodes: the numbers of its corners in the ring.
  struct Side {
    std::size_t corners;
    std::array<std::size_t, 3> at;
  };
  /// Barycentric.
  using Shares = std::array<double, 3>;

  std::int32_t number(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return i + 1 + width_ * (j + 1 + height_ * (k + 1));
  }
  Vector place(std::int32_t node) const;
  const Node& node(std::int32_t number) const { return nodes_[static_cast<std::size_t>(number)]; }
  Node& node(std::int32_t number) { return nodes_[static_cast<std::size_t>(number)]; }
  void list_sides();
  /// The corner of a side of a node; null: nothing has arrived there.
  const Node* corner(std::int32_t number, const Side& side, std::size_t c) const;
  /// Where the sum of linear u, with these values at the corners, and the line element is least over the plane of a
  /// side, which may be beside it. False: nowhere.
  bool least_over(const Side& side, const DriftMetric& element, const std::array<double, 3>& u, Shares& shares) const;
  /// What comes over a side; false where nothing does. `sharp`: with the gradients at the corners.
  bool over(std::int32_t number, const Side& side, bool sharp, Offer& offer) const;
  /// The cheapest of offers that obstacles let pass; null where there is none.
  const Offer* passing(std::int32_t number, std::vector<Offer>& offers) const;
  void take(std::int32_t number, const Offer& offer);
  bool improve(std::int32_t number, std::size_t by);
  void spread(const std::function<bool()>& stop);
  /// Whether u has changed.
  bool sharpen_node(std::int32_t number);
  void sharpen(const std::function<bool()>& stop);

  Lattice lattice_;
  Passes passes_;
  std::int32_t width_, height_;  ///< of the frame
  std::array<std::int32_t, 26> ring_{};
  std::array<Vector, 26> places_;  ///< of the ring, relative to the node
  std::vector<Side> sides_;
  std::array<std::vector<Side>, 26> with_;  ///< those with that node of the ring among their corners
  std::vector<Node> nodes_;                 ///< in a frame of one node
  std::vector<unsigned char> fixed_;        ///< reached straight from a source
  std::vector<std::int32_t> started_;
  std::vector<Offer> offers_;
};

}  // namespace leastcost
