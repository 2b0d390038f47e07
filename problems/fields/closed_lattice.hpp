// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include "problems/fields/isotropic_march.hpp"
#include "problems/fields/lattice_box.hpp"

namespace leastcost {

/// What the chart of a problem says of the box of a field.
struct ChartBox {
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  /// Sides that the chart has: one period along a seam, poles, edges; infinite where it says nothing.
  Eigen::Vector2d lower = Eigen::Vector2d::Constant(-kNone), upper = Eigen::Vector2d::Constant(kNone);
  std::vector<SeamMap> poles = {};  ///< places beyond a pole have another name on its near side
  std::vector<Seam> seams = {};     ///< across which the box closes on itself; none where an edge cuts the chart open
  bool complete() const { return lower.allFinite() && upper.allFinite(); }  ///< the whole box is known
};

/// Of a domain in two coordinates. Throws InputError for coordinates that come back without a chart that says how, as
/// the angles of joints do.
ChartBox chart_box(const Problem& problem);

/// Makes the steps along closed axes a whole, even number: their first and last nodes are the same places, and a
/// lattice of every second node has them too. Throws InputError where the steps must not change (`equal_steps`).
void close_lattice(const std::vector<Seam>& seams, bool equal_steps, IsotropicMarch::Lattice& lattice);

/// A closed lattice laid out beyond its seams, by half a period at each end: a field over it from all images of the
/// sources has the values of the closed one, the least of all images of a node, for every path that goes round less
/// than once.
class LaidOut {
 public:
  LaidOut(const IsotropicMarch::Lattice& closed, const std::vector<Seam>& seams);
  const IsotropicMarch::Lattice& lattice() const { return wide_; }
  /// The images of places that are on the lattice; the first is the first place itself.
  std::vector<Eigen::VectorXd> images(const std::vector<Eigen::VectorXd>& places) const;
  /// Values of the closed lattice from those of this one, row by row.
  std::vector<double> folded(const std::vector<double>& values) const;
  /// The other way round.
  std::vector<double> unfolded(const std::vector<double>& values) const;

 private:
  /// Number of the closed lattice's node that node (i, j) is; -1: none, beyond an edge.
  std::int64_t closed_node(std::int32_t i, std::int32_t j) const;

  IsotropicMarch::Lattice closed_, wide_;
  std::vector<Seam> seams_;
  std::array<std::int32_t, 2> before_ = {0, 0};  ///< nodes of this lattice before those of the closed one
};

/// The name of a place in the period, and between the poles, that a lattice covers.
Eigen::VectorXd in_period(const IsotropicMarch::Lattice& lattice, const std::vector<Seam>& seams,
                          const std::vector<SeamMap>& poles, const Eigen::VectorXd& place);

}  // namespace leastcost
