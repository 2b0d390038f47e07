// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/problems/bracket/coordinate_cost.hpp>
#include <leastcost/problems/bracket/cost_density.hpp>
#include <leastcost/problems/bracket/cost_dual.hpp>

namespace leastcost {

/// A potential on square cells in a box: u = a biquadratic spline whose coefficients are numbers at the centres of the
/// cells and of a row around them, with |grad u| <= ratio n, or H(x, grad u) <= ratio for a cost that depends on the
/// direction (DualNorm), in the searched cells outside the squares around the ends.
/// What a proof rests on, and what a picture of it shows.
struct BracketPotential {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< lower left one of the box
  double side = 1;                                   ///< of a cell, length units
  int nx = 0, ny = 0;                                ///< cells
  std::vector<double> coefficients;                  ///< (nx + 2) x (ny + 2), row by row, from the ring outside on
  std::vector<unsigned char> searched;               ///< per coefficient: whether its cell may hold a cheaper path
  double ratio = 1;
  double cap = std::numeric_limits<double>::infinity();  ///< beyond it, in size, nothing is proved, and nothing needed
  int source_rings = 0, target_rings = 0;  ///< squares of (2 rings + 1)^2 cells around the ends; -1: there is none
  Eigen::Vector2d source = Eigen::Vector2d::Zero(), target = Eigen::Vector2d::Zero();

  /// Whether x lies in a searched cell outside the squares around the ends, and within the cap: where the inequality
  /// is proved.
  bool is_checked(const Eigen::Vector2d& x) const;
  double value(const Eigen::Vector2d& x) const;
  Eigen::Vector2d gradient(const Eigen::Vector2d& x) const;
};

struct BracketOptions {
  double tolerance = 1e-4;    ///< relative gap at which it is done
  int cells = 128;            ///< of the first grid, along the longer side of the box
  int max_cells = 4096;       ///< of the last one
  double max_searched = 4e6;  ///< cells of a grid that are searched at most: memory
  /// Obstacles: how deep a place lies in what no path enters, positive inside, at most its distance from all places
  /// outside; none: there are no obstacles.
  std::function<double(const Eigen::Vector2d&)> depth = {};
  std::function<bool()> stop = {};  ///< looked at between the steps of a grid
  /// Whether a way down the field, which costs less than what is known, is one to go on from instead: then the search
  /// ends, for its gap would be that of a path that nobody delivers. None: it never does.
  std::function<bool(const Eigen::Matrix2Xd&)> takes_way = {};
};

/// Bounds of the least cost of all paths in a box between two places.
struct Bracket {
  double lower = 0;                                        ///< proved
  double upper = std::numeric_limits<double>::infinity();  ///< of a path that is known, proved
  /// A path down the field of the source, where it costs less than was known: that of `upper`, or among obstacles a
  /// hint, for it may enter them by a cell.
  Eigen::Matrix2Xd way = {};
  Eigen::AlignedBox2d box = {};
  std::array<int, 2> grid = {0, 0};  ///< cells of the finest grid over the box, of which a part was searched
  long cells = 0;                    ///< searched on all grids
  int grids = 0;
  bool stopped = false;                               ///< by options.stop or a limit, before the tolerance was reached
  bool way_taken = false;                             ///< the search has ended with options.takes_way
  std::shared_ptr<const BracketPotential> potential;  ///< of `lower`

  double gap() const { return !std::isfinite(upper) ? 1 : lower < upper ? (upper - lower) / upper : 0; }
};

/// No path in the box from `source` to `target` costs less than `lower`: for a potential u with |grad u| <= n every
/// path costs at least u(target) - u(source). The potential comes from fast marching, second order by correction of its
/// defect, as a biquadratic spline; the inequality is proved cell by cell in outward rounded arithmetic; finer grids
/// cover only what a path of at most `upper` can reach. `upper`: proved cost of a path that is known, or infinity; then
/// the way down the field takes its place, where there are no obstacles. docs/numerics.md Sec. 6.10 says what is
/// trusted. Throws InputError for ends outside the box or a box without area.
Bracket bracket_least_cost(const CostDensity& density, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& source,
                           const Eigen::Vector2d& target, double upper = std::numeric_limits<double>::infinity(),
                           const BracketOptions& options = {});

/// The same of a cost that depends on the direction, there and back alike or not: metrics, winds. H(x, grad u) <= 1
/// takes the place of |grad u| <= n.
Bracket bracket_least_cost(const CostDual& dual, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& source,
                           const Eigen::Vector2d& target, double upper = std::numeric_limits<double>::infinity(),
                           const BracketOptions& options = {});

/// The same of a cost that is known by its values only, in the coordinates of its domain: nothing is proved. The
/// inequality is looked at, at four places of each cell, and so are the surroundings of the ends; `lower` and `upper`
/// are what they are if nothing lies in between.
Bracket bracket_least_cost(const CoordinateCost& cost, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& source,
                           const Eigen::Vector2d& target, double upper = std::numeric_limits<double>::infinity(),
                           const BracketOptions& options = {});

}  // namespace leastcost
