// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/problems/bracket/space/space_density.hpp>

namespace leastcost {

/// A potential on cubic cells in a box of space: u = a triquadratic spline, with |grad u| <= ratio n in the searched
/// cells outside the balls around the ends. What a proof rests on.
class SpacePotential {
 public:
  virtual ~SpacePotential() = default;
  /// Whether x lies in a searched cell outside the balls around the ends: where the inequality is proved.
  virtual bool is_checked(const Eigen::Vector3d& x) const = 0;
  /// NaN, as the gradient, where the spline has no coefficients.
  virtual double value(const Eigen::Vector3d& x) const = 0;
  virtual Eigen::Vector3d gradient(const Eigen::Vector3d& x) const = 0;
  virtual double ratio() const = 0;
};

struct SpaceBracketOptions {
  double tolerance = 1e-3;    ///< relative gap at which it is done
  int cells = 48;             ///< of the first grid, along the longest side of the box
  int max_cells = 1024;       ///< of the last one
  double max_searched = 2e6;  ///< cells of a grid that are searched at most: memory
  /// Obstacles: how deep a place lies in what no path enters, positive inside, at most its distance from all places
  /// outside; none: there are no obstacles.
  std::function<double(const Eigen::Vector3d&)> depth = {};
  std::function<bool()> stop = {};                              ///< looked at between the steps of a grid
  std::function<bool(const Eigen::Matrix3Xd&)> takes_way = {};  ///< as of BracketOptions
};

/// Bounds of the least cost of all paths in a box of space between two places, as Bracket has them in the plane.
struct SpaceBracket {
  double lower = 0;                                        ///< proved
  double upper = std::numeric_limits<double>::infinity();  ///< of a path that is known, proved
  /// A path down the field of the source, where it costs less than was known: that of `upper`, or among obstacles a
  /// hint, for it may enter them by a cell.
  Eigen::Matrix3Xd way = {};
  Eigen::AlignedBox3d box = {};
  std::array<int, 3> grid = {0, 0, 0};  ///< cells of the finest grid over the box, of which a part was searched
  long cells = 0;                       ///< searched on all grids
  int grids = 0;
  bool stopped = false;                             ///< by options.stop or a limit, before the tolerance was reached
  bool way_taken = false;                           ///< the search has ended with options.takes_way
  std::shared_ptr<const SpacePotential> potential;  ///< of `lower`

  double gap() const { return !std::isfinite(upper) ? 1 : lower < upper ? (upper - lower) / upper : 0; }
};

/// No path in the box from `source` to `target` costs less than `lower`; as for a box of the plane, with triquadratic
/// splines on cubic cells. Finer grids have nodes only where a path of at most `upper` can come. `upper`: proved cost
/// of a path that is known, or infinity; then the way down the field takes its place, where there are no obstacles.
/// docs/numerics.md Sec. 6.10. Throws InputError for ends outside the box or a box without volume.
SpaceBracket bracket_least_cost(const SpaceDensity& density, const Eigen::AlignedBox3d& box,
                                const Eigen::Vector3d& source, const Eigen::Vector3d& target,
                                double upper = std::numeric_limits<double>::infinity(),
                                const SpaceBracketOptions& options = {});

}  // namespace leastcost
