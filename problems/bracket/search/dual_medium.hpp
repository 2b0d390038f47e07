// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/bracket/cells/dual_check.hpp"
#include "problems/bracket/cells/end_square.hpp"
#include "problems/bracket/search/medium.hpp"

namespace leastcost::bracket {

/// A cost in the plane that depends on the direction, by its dual norm.
class DualMedium {
 public:
  static constexpr int kDimension = 2;
  static constexpr bool kIsotropic = false, kSeedsGiveWay = false;
  static constexpr int kBisectorDeflations = 6, kFieldDeflations = 4, kPatience = 1;
  using End = EndSquare<DualCone>;

  explicit DualMedium(const CostDual& cost) : cost_(cost) {}

  double density(const Eigen::Vector2d& x) const { return std::isfinite(cost_.dual(x).xx) ? 1 : kInfinity; }
  End end(const Grid<2>& grid, const Eigen::Vector2d& place, int k, bool reversed) const {
    return end_square(cost_, grid, place, k, reversed);
  }
  double cost_near(const End& end, const Grid<2>& grid, const Eigen::Vector2d& x, double density_there) const;
  double polyline_above(const Way<2>& x) const { return polyline_cost_above(cost_, x); }

  /// The norms at the nodes, and what is known of them in the cells.
  class Known {
   public:
    void begin(const DualMedium&, const Part<2>& part) { norms_.resize(part.density.size()); }
    void learn_node(const DualMedium& medium, const Part<2>&, int node, const Eigen::Vector2d& x) {
      norms_[static_cast<std::size_t>(node)] = medium.cost_.dual(x);
    }
    void end_of_nodes(const Part<2>&) {}
    void learn_cell(const DualMedium& medium, const Part<2>& part, int node, bool) {
      cells_.push_back(dual_cell(medium.cost_, part.grid, part.nodes.place(node)));
    }
    void end_of_cells(const DualMedium&, const Part<2>&) {}

    double size(int node, const Eigen::Vector2d& p, bool reversed) const {
      const double sign = reversed ? -1 : 1;
      return norms_[static_cast<std::size_t>(node)](sign * p[0], sign * p[1]);
    }
    Eigen::Vector2d steepest(int node, const Eigen::Vector2d& p) const;
    double ratio(const Part<2>& part, const Net<2>& coefficients, double largest, std::size_t k, bool reversed,
                 const BlockedParts& blocked) const {
      return proved_dual_ratio(coefficients, part.grid.h, largest, reversed ? -1 : 1, cells_[k], {}, blocked);
    }
    void march(const Part<2>& part, const Front& front, std::vector<double>& u, const FastMarching& marching) const;
    void spread(const Part<2>&, std::vector<double>&) const {}

   private:
    std::vector<DualNorm<double>> norms_;
    std::vector<DualCell> cells_;
  };

 private:
  const CostDual& cost_;
};

}  // namespace leastcost::bracket
