// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "problems/bracket/plane/blocked_parts.hpp"
#include "problems/bracket/plane/dual_check.hpp"
#include "problems/bracket/plane/end_region.hpp"
#include "problems/bracket/plane/fast_marching.hpp"
#include "problems/bracket/plane/sampled_check.hpp"
#include "problems/bracket/plane/sampled_norms.hpp"
#include "problems/bracket/plane/spline_check.hpp"

namespace leastcost::bracket {

/// What paths run through: a density, a dual norm or a cost by its values, and obstacles that no path enters. `depth`
/// of a place is at most its distance from all places outside them, positive inside; none: there are no obstacles.
class Medium {
 public:
  using Depth = std::function<double(const Eigen::Vector2d&)>;
  Medium(const CostDensity& n, const Depth& in_obstacles) : density(&n), depth(in_obstacles) {}
  Medium(const CostDual& norm, const Depth& in_obstacles) : dual(&norm), depth(in_obstacles) {}
  Medium(const CoordinateCost& cost, const Eigen::AlignedBox2d& box, const Depth& in_obstacles)
      : sampled(&cost), directions(directions_for(cost, box)), depth(in_obstacles) {}

  const CostDensity* density = nullptr;  ///< one of the three is there
  const CostDual* dual = nullptr;
  const CoordinateCost* sampled = nullptr;
  int directions = 0;  ///< that it is asked for at each node
  const Depth& depth;

  /// Whether a cell lies within the obstacles, so that nothing need be proved in it.
  bool is_blocked(const CellGrid& grid, int i, int j) const {
    return depth && depth(grid.node(i, j)) > grid.half_diagonal();
  }
  /// How deep a node lies in an obstacle, 0 outside.
  double depth_of(const CellGrid& grid, int i, int j) const {
    return depth ? std::max(0.0, depth(grid.in_box(grid.node(i, j)))) : 0;
  }
  /// The density that fronts are marched with, times the dual norm: it grows with the depth in an obstacle, so that
  /// potentials go on smoothly a little way.
  double marched(const CellGrid& grid, int i, int j, double depth_here) const;
  bool is_known_at(const Eigen::Vector2d& x) const;  ///< its dual norm, or its values
  /// As of its density or dual norm; of a cost by its values, those.
  double polyline_above(const Eigen::Ref<const Eigen::Matrix2Xd>& x) const {
    if (sampled != nullptr) return polyline_cost(*sampled, x);
    return dual != nullptr ? polyline_cost_above(*dual, x) : polyline_cost_above(*density, x);
  }
  /// `reversed`: of the cost to the end.
  EndRegion end_region(const CellGrid& grid, const Eigen::Vector2d& place, int k, bool reversed) const;
};

/// One grid, and the part of it in which a cheaper path may run.
struct Level {
  CellGrid grid;
  std::vector<double> density;          ///< n at the nodes, or 1; infinite where fronts do not go
  std::vector<DualNorm<double>> duals;  ///< at those nodes; empty where there are none in closed form
  SampledNorms norms;                   ///< at those nodes; empty where the cost is not sampled
  std::vector<unsigned char> searched;  ///< per node: its cell may hold a cheaper path, the inequality is checked in it
  std::vector<int> cells;               ///< those nodes
  std::vector<Net> floors;              ///< per cell: what is below n
  std::vector<DualCell> dual_cells;     ///< per cell: what is known of the dual norm
  SampledCells sampled_cells;           ///< where the inequality is looked at, where it is not proved
  std::vector<BlockedParts> blocked;    ///< per cell; empty where there are no obstacles

  /// The dual norm of a gradient at a node; its length where there is a density.
  double size(std::size_t node, double px, double py, bool reversed) const {
    const double sign = reversed ? -1 : 1;
    if (!norms.empty()) return norms.dual(node, {sign * px, sign * py});
    return duals.empty() ? std::sqrt(px * px + py * py) : duals[node](sign * px, sign * py);
  }
  /// Its slope: the move of cost 1, or of length 1 under a density, along which u rises most.
  Eigen::Vector2d steepest(std::size_t node, const Eigen::Vector2d& p) const {
    if (!norms.empty()) return norms.steepest(node, p);
    if (duals.empty()) return p.normalized();
    const DualNorm<double>& norm = duals[node];
    const double root = std::sqrt(norm.squared(p[0], p[1]));
    return {(norm.xx * p[0] + norm.xy * p[1]) / root + norm.wx, (norm.xy * p[0] + norm.yy * p[1]) / root + norm.wy};
  }
  bool is_isotropic() const { return norms.empty() && duals.empty(); }
};

/// The whole box. These throw Stopped.
Level whole_level(const Medium& medium, const Eigen::AlignedBox2d& box, int cells, const StopLook& look);

/// Fills the density in and around the searched cells.
void fill_density(const Medium& medium, Level& level, const StopLook& look);

/// The same, and the bounds of the searched cells.
void fill_level(const Medium& medium, Level& level, const StopLook& look);

/// What a potential is marched from: values at seeds, and the density, which corrections change. `sign`: per node;
/// empty: all 1. `order`: of the nodes in the first march, which the others follow; empty under a dual norm, where no
/// order is right.
struct Front {
  std::vector<int> seeds;
  std::vector<double> values;  ///< at the seeds, infinite elsewhere
  std::vector<double> density;
  std::vector<signed char> sign;
  std::vector<int> order;
  bool reversed = false;  ///< of costs to the seeds, not from them
};

}  // namespace leastcost::bracket
