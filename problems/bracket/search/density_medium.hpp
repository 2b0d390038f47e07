// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "problems/bracket/cells/density_floor.hpp"
#include "problems/bracket/cells/end_ball.hpp"
#include "problems/bracket/cells/end_square.hpp"
#include "problems/bracket/cells/spline_check.hpp"
#include "problems/bracket/search/medium.hpp"

namespace leastcost::bracket {

/// A cost that is the same in all directions, in the plane or in space.
template <int N>
class DensityMedium {
 public:
  static constexpr int kDimension = N;
  static constexpr bool kIsotropic = true, kSeedsGiveWay = false;
  static constexpr int kBisectorDeflations = N == 2 ? 6 : 8, kFieldDeflations = 4, kPatience = 1;
  using Cost = std::conditional_t<N == 2, CostDensity, SpaceDensity>;
  using End = std::conditional_t<N == 2, EndSquare<DensityCone>, EndBall>;

  explicit DensityMedium(const Cost& cost) : cost_(cost) {}

  double density(const Vector<N>& x) const { return cost_.density(x); }
  End end(const Grid<N>& grid, const Vector<N>& place, int k, bool /*reversed*/) const {
    if constexpr (N == 2)
      return end_square(cost_, grid, place, k);
    else
      return end_ball(cost_, grid, place, k);
  }
  /// Of the straight move by Simpson's rule, less what a curve saves.
  double cost_near(const End& end, const Grid<N>& grid, const Vector<N>& x, double density_there) const;
  double polyline_above(const Way<N>& x) const { return polyline_cost_above(cost_, x); }

  /// What lies below the density in the cells.
  class Known {
   public:
    void begin(const DensityMedium&, const Part<N>&) {}
    void learn_node(const DensityMedium&, const Part<N>&, int, const Vector<N>&) {}
    void end_of_nodes(const Part<N>&) {}
    void learn_cell(const DensityMedium& medium, const Part<N>& part, int node, bool is_fine) {
      floors_.add_cell(medium.cost_, part.grid, part.nodes.place(node), is_fine);
    }
    void end_of_cells(const DensityMedium&, const Part<N>&) {}

    double size(int, const Vector<N>& p, bool) const { return p.norm(); }
    Vector<N> steepest(int, const Vector<N>& p) const { return p.normalized(); }
    double ratio(const Part<N>& part, const Net<N>& coefficients, double largest, std::size_t k, bool /*reversed*/,
                 const Blocked<N>& blocked) const {
      const Net<N>& floor = floors_.on_cell(part.grid, part.nodes.place(part.cells[k]), k);
      return proved_ratio<N>(coefficients, part.grid.h, largest, floor, {}, blocked);
    }
    void march(const Part<N>& part, Front& front, std::vector<double>& u, FastMarching& marching) const {
      if (front.order.empty())
        marching.run(part.nodes, part.grid.h, front.density, front.seeds, u, front.order);
      else
        marching.follow(part.nodes, part.grid.h, front.density, front.order, u);
    }
    void spread(const Part<N>&, std::vector<double>&) const {}

   private:
    Floors<N> floors_;
  };

 private:
  const Cost& cost_;
};

}  // namespace leastcost::bracket
