// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/bracket/cells/end_square.hpp"
#include "problems/bracket/cells/sampled_check.hpp"
#include "problems/bracket/cells/sampled_norms.hpp"
#include "problems/bracket/search/medium.hpp"

namespace leastcost::bracket {

/// A cost in two coordinates that is known by its values only: what the others prove is looked at in places.
class SampledMedium {
 public:
  static constexpr int kDimension = 2;
  /// Kinks of a cost ask for more rounds, some of which bring little.
  static constexpr bool kIsotropic = false, kSeedsGiveWay = true;
  static constexpr int kBisectorDeflations = 12, kFieldDeflations = 8, kPatience = 3;
  using End = EndSquare<SampledCone>;

  SampledMedium(const CoordinateCost& cost, const Eigen::AlignedBox2d& box)
      : cost_(cost), directions_(directions_for(cost, box)) {}

  double density(const Eigen::Vector2d& x) const {
    return CoordinateCost::Element(cost_, x).is_inside() ? 1 : kInfinity;
  }
  End end(const Grid<2>& grid, const Eigen::Vector2d& place, int k, bool reversed) const {
    return end_square(cost_, grid, place, k, reversed);
  }
  double cost_near(const End& end, const Grid<2>& grid, const Eigen::Vector2d& x, double density_there) const;
  /// Nothing above it is proved: the cost by its values.
  double polyline_above(const Way<2>& x) const { return polyline_cost(cost_, x); }

  /// Values at the nodes, and places in the cells.
  class Known {
   public:
    void begin(const SampledMedium& medium, const Part<2>& part) {
      norms_.reset(part.density.size(), medium.directions_);
    }
    void learn_node(const SampledMedium& medium, const Part<2>& part, int node, const Eigen::Vector2d& x);
    /// Where the domain has no places fronts run on as in obstacles: with the norm of the nearest node that has one,
    /// and a density that grows.
    void end_of_nodes(Part<2>& part);
    void learn_cell(const SampledMedium&, const Part<2>&, int, bool) {}
    void end_of_cells(const SampledMedium& medium, const Part<2>& part) {
      cells_ = SampledCells(medium.cost_, part.grid, part.nodes, part.cells);
    }

    double size(int node, const Eigen::Vector2d& p, bool reversed) const {
      return norms_.dual(static_cast<std::size_t>(node), reversed ? Eigen::Vector2d(-p) : p);
    }
    Eigen::Vector2d steepest(int node, const Eigen::Vector2d& p) const {
      return norms_.steepest(static_cast<std::size_t>(node), p);
    }
    double ratio(const Part<2>& part, const Net<2>& coefficients, double /*largest*/, std::size_t k, bool reversed,
                 const BlockedParts& blocked) const {
      return cells_.ratio(coefficients, part.grid.h, k, reversed ? -1 : 1, blocked);
    }
    void march(const Part<2>& part, const Front& front, std::vector<double>& u, const FastMarching& marching) const;
    /// Where a cost has kinks potentials have edges along ways: a density that jumps beside them makes new ones.
    void spread(const Part<2>& part, std::vector<double>& excess) const;

   private:
    SampledNorms norms_;
    SampledCells cells_;
    std::vector<int> unknown_;  ///< nodes where the domain has no places
  };

 private:
  const CoordinateCost& cost_;
  const int directions_;  ///< that it is asked for at each node
};

}  // namespace leastcost::bracket
