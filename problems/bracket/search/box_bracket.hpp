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

namespace leastcost {

/// A potential on the square cells of a box in the plane, or the cubic ones of a box in space: u = a spline of degree
/// two along each axis, with |grad u| <= ratio n, or H(x, grad u) <= ratio for a cost that depends on the direction
/// (DualNorm), in the searched cells outside the sets of cells around the ends. What a proof rests on, and what a
/// picture of it shows.
template <int N>
class BoxPotential {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  virtual ~BoxPotential() = default;
  /// Whether x lies where the inequality is proved: in a searched cell outside the sets around the ends, and where |u|
  /// is not so large that nothing is needed.
  virtual bool is_checked(const Vector& x) const = 0;
  /// NaN, as the gradient, where the spline has no coefficients.
  virtual double value(const Vector& x) const = 0;
  virtual Vector gradient(const Vector& x) const = 0;  ///< of value(), by place
  virtual double ratio() const = 0;                    ///< no slope is greater than so many times the cost per length
  /// Around all searched cells.
  virtual Eigen::AlignedBox<double, N> searched() const = 0;
};
using BracketPotential = BoxPotential<2>;
using SpacePotential = BoxPotential<3>;

template <int N>
struct BoxBracketOptions {
  double tolerance = N == 2 ? 1e-4 : 1e-3;   ///< relative gap at which it is done
  int cells = N == 2 ? 128 : 48;             ///< of the first grid, along the longest side of the box
  int max_cells = N == 2 ? 4096 : 1024;      ///< of the last one
  double max_searched = N == 2 ? 4e6 : 2e6;  ///< cells of a grid that are searched at most: memory
  /// Obstacles: how deep a place lies in what no path enters, positive inside, at most its distance from all places
  /// outside; none: there are no obstacles.
  std::function<double(const Eigen::Matrix<double, N, 1>&)> depth = {};
  std::function<bool()> stop = {};  ///< looked at between the steps of a grid
  /// Whether a way down the field, which costs less than what is known, is one to go on from instead: then the search
  /// ends, for its gap would be that of a path that nobody delivers. None: it never does.
  std::function<bool(const Eigen::Matrix<double, N, Eigen::Dynamic>&)> takes_way = {};
};
using BracketOptions = BoxBracketOptions<2>;
using SpaceBracketOptions = BoxBracketOptions<3>;

/// Bounds of the least cost of all paths in a box between two places.
template <int N>
struct BoxBracket {
  double lower = 0;                                        ///< proved
  double upper = std::numeric_limits<double>::infinity();  ///< of a path that is known, proved
  /// A path down the field of the source, where it costs less than was known: that of `upper`, or among obstacles a
  /// hint, for it may enter them by a cell.
  Eigen::Matrix<double, N, Eigen::Dynamic> way = {};
  Eigen::AlignedBox<double, N> box = {};                   ///< what was searched
  std::array<int, static_cast<std::size_t>(N)> grid = {};  ///< cells of the finest grid over the box, partly searched
  long cells = 0;                                          ///< searched on all grids
  int grids = 0;                                           ///< grids that were searched
  bool stopped = false;                              ///< by options.stop or a limit, before the tolerance was reached
  bool way_taken = false;                            ///< the search has ended with options.takes_way
  std::shared_ptr<const BoxPotential<N>> potential;  ///< of `lower`

  /// Relative distance of the bounds; 1: one of them says nothing.
  double gap() const { return !std::isfinite(upper) ? 1 : lower < upper ? (upper - lower) / upper : 0; }
};
using Bracket = BoxBracket<2>;
using SpaceBracket = BoxBracket<3>;

}  // namespace leastcost
