// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/end_square.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <leastcost/framework/numbers/dual.hpp>
#include "problems/bracket/cone_bound.hpp"

namespace leastcost::bracket {
namespace {

using Eigen::Vector2d;
using DensitySquare = EndSquare<DensityCone>;

constexpr double kSafety = 1 + 1e-12;
constexpr int kLeastRings = 1, kLeastDualRings = 2;
constexpr int kPieces = 16;  ///< per side of a cell on the rim
constexpr int kParts = 8;    ///< of a part of the box, along each axis

double radius_of(const Interval& x) { return std::max(x.hi - x.middle(), x.middle() - x.lo); }

/// The largest K with which -d'H d <= K |d|^2 for the second derivatives H in a part of the box, from small parts of
/// it; infinite where nothing is known.
double curvature_bound(const CostDensity& density, const Eigen::AlignedBox2d& box) {
  double worst = 0;
  const bool known = for_parts_of<2>(box, kParts, [&](const Eigen::AlignedBox2d& part) {
    const DensityEnclosure n = density.enclose_density(part);
    const double a = n.xx.lo, b = n.yy.lo, c = n.xy.magnitude();
    worst = std::max(worst, (std::hypot((a - b) / 2, c) - (a + b) / 2) * kSafety + 1e-14 * (std::abs(a) + std::abs(b)));
    return n.is_finite() && n.slack == 0;
  });
  return known ? worst : kInfinity;
}

/// Fills the cone for an S2 that is `wider` times as wide as S; false where its conditions fail.
bool make_cone(const CostDensity& density, const Grid<2>& grid, double wider, DensitySquare& square) {
  const double inner = (square.k + 0.5) * grid.h, outer = wider * inner + grid.h;
  const Vector2d off = (square.place - grid.node(square.middle)).cwiseAbs();
  const double to_rim = (outer - off.maxCoeff()) / kSafety;
  const double reach = (Vector2d(outer, outer) + off).norm() * kSafety,
               inner_reach = (Vector2d(inner, inner) + off).norm() * kSafety;
  const DensityEnclosure at = density.enclose_density({square.place, square.place});
  if (!at.is_finite() || at.slack != 0) return false;
  square.cone.gx = at.dx.middle();
  square.cone.gy = at.dy.middle();
  const double unsure = (radius_of(at.dx) + radius_of(at.dy)) * reach * kSafety;
  square.cone.n0 = at.value.lo - unsure;
  const double g = std::hypot(square.cone.gx, square.cone.gy) * kSafety;
  const double bend = curvature_bound(density, grid.cell(square.middle, outer / grid.h - 0.5));
  square.cone.c = cubic_of_cone(square.cone.n0, g, bend, reach);
  if (!std::isfinite(square.cone.c)) return false;
  const ConeBound cone = {square.cone.n0, g, square.cone.c};
  const double largest = inner_reach * (square.cone.n0 + g * inner_reach / 2);
  return cone_rises(cone, reach) && cone_at_least(cone, to_rim) > largest * kSafety;
}

/// The least a density has in a part of the box, from its enclosure there.
double least_within(const DensityEnclosure& n, const Eigen::AlignedBox2d& part) {
  const Vector2d r = part.sizes() / 2 + 4 * kEps * (part.min().cwiseAbs() + part.max().cwiseAbs());
  const Interval x(-r[0], r[0]), y(-r[1], r[1]), half(0.5);
  return (n.value - n.slack + n.dx * x + n.dy * y + half * (n.xx * square(x) + n.yy * square(y)) + n.xy * x * y).lo;
}

/// A cone that rises by the least density in S2, where the other one fails because n is bent too much or has kinks: it
/// loses of the second order in the width of S, which does on coarse grids.
bool make_straight_cone(const CostDensity& density, const Grid<2>& grid, DensitySquare& square) {
  constexpr double kWider = 1.6;
  const double inner = (square.k + 0.5) * grid.h, outer = kWider * inner + grid.h;
  const Vector2d off = (square.place - grid.node(square.middle)).cwiseAbs();
  const double to_rim = (outer - off.maxCoeff()) / kSafety,
               inner_reach = (Vector2d(inner, inner) + off).norm() * kSafety;
  square.cone.gx = square.cone.gy = square.cone.c = 0;
  square.cone.n0 = kInfinity;
  const bool known = for_parts_of<2>(grid.cell(square.middle, outer / grid.h - 0.5), kParts, [&](const auto& part) {
    const DensityEnclosure n = density.enclose_density(part);
    square.cone.n0 = std::min(square.cone.n0, least_within(n, part));
    return n.is_finite();
  });
  return known && square.cone.n0 > 0 && to_rim > inner_reach * kSafety;
}

/// A side of a cell on the rim, and the step along `axis` to the cell beyond.
struct Side {
  Place<2> cell;
  std::size_t axis;
  int out;

  std::size_t along() const { return 1 - axis; }
  /// The place t along the side, from -1/2 to 1/2, in the cell.
  template <class S>
  std::array<S, 2> at(const S& t) const {
    std::array<S, 2> place;
    place[axis] = S(0.5 * out);
    place[along()] = t;
    return place;
  }
};

/// From an end to the node of the cell.
std::array<Interval, 2> to_node(const Grid<2>& grid, const Vector2d& place, const Side& side) {
  const auto along = [&](std::size_t k) {
    const auto axis = static_cast<int>(k);
    return Interval(grid.corner[axis]) + (Interval(side.cell[k]) - 0.5) * Interval(grid.h) - Interval(place[axis]);
  };
  return {along(0), along(1)};
}

template <class Cone>
bool is_left_by(const AllNodes& nodes, const EndSquare<Cone>& square, const std::vector<unsigned char>& searched,
                const Side& side) {
  for (int along = -1; along <= 1; ++along) {
    Place<2> p = side.cell;
    p[side.axis] += side.out;
    p[side.along()] += along;
    if (!square.holds(p) && searched[static_cast<std::size_t>(nodes.find(p))]) return true;
  }
  return false;
}

/// On one side: least value at the ends of its pieces, less what the function can fall between them.
double side_minimum(const Grid<2>& grid, const DensitySquare& square, const Side& side, const Net<2>& u, double sign,
                    double ratio) {
  const DensityCone& cone = square.cone;
  const Interval h(grid.h);
  const auto x_node = [&](std::size_t k) {
    return Interval(grid.corner[static_cast<int>(k)]) + (Interval(side.cell[k]) - 0.5) * h;
  };
  double least = kInfinity;
  for (int piece = 0; piece <= kPieces; ++piece) {
    const std::array<Interval, 2> at = side.at(Interval(-0.5 + static_cast<double>(piece) / kPieces));
    const Interval v = cone.value(x_node(0) + at[0] * h - Interval(square.place[0]),
                                  x_node(1) + at[1] * h - Interval(square.place[1]));
    const double value = (v + Interval(sign) * spline_value<2>(u, at) / Interval(ratio)).lo;
    if (!(value >= least)) least = value;
  }
  // Second derivative along the side: of v at most n0 / distance + 3 |g| / 2, of u constant.
  const Vector2d off = (square.place - grid.node(square.middle)).cwiseAbs();
  const double away = (square.k + 0.5) * grid.h - off.maxCoeff();
  const std::size_t step = kNetStep[side.along()];
  const auto difference = [&](std::size_t at) {
    const double before = u[at - step], here = u[at], after = u[at + step];
    return std::abs(after - 2 * here + before) + 4e-15 * (std::abs(after) + std::abs(here) + std::abs(before));
  };
  const std::size_t middle = kNetMiddle<2>,
                    beyond = side.out > 0 ? middle + kNetStep[side.axis] : middle - kNetStep[side.axis];
  const double bend_u = std::max(difference(middle), difference(beyond));
  const double bend = cone.n0 / away + 1.5 * std::hypot(cone.gx, cone.gy) + bend_u / (grid.h * grid.h * ratio);
  const double length = grid.h / kPieces;
  const double bound = least - length * length / 8 * bend * (1 + 1e-10);
  return bound == bound ? bound : -kInfinity;
}

/// What the second derivative of the spline along a side lies in, in units of the cell.
Interval bend_along(const Net<2>& u, const Side& side) {
  const std::size_t step = kNetStep[side.along()];
  Interval out;
  bool first = true;
  for_lines<9>(side.along(), [&](std::size_t at) {
    const Interval here =
        (Interval(u[at + 2 * step]) - Interval(u[at + step])) - (Interval(u[at + step]) - Interval(u[at]));
    out = first ? here : hull(out, here);
    first = false;
  });
  return out;
}

/// The same for the cone of a dual norm: on each piece by the value in its middle and the slopes on it.
double side_minimum(const Grid<2>& grid, const EndSquare<DualCone>& square, const Side& side, const Net<2>& u,
                    double sign, double ratio) {
  using Slope = Dual<Interval, 1>;
  constexpr int kFinePieces = 32;
  const std::array<Interval, 2> node = to_node(grid, square.place, side);
  const Interval scale = Interval(sign) / Interval(ratio), bend = bend_along(u, side);
  const auto at = [&](const Interval& t) { return side.at(Slope(t, {Interval(1)})); };
  const auto cone = [&](const std::array<Slope, 2>& p) {
    return square.cone.value<Slope>(Slope(node[0], {}) + p[0] * Slope(grid.h),
                                    Slope(node[1], {}) + p[1] * Slope(grid.h));
  };
  double least = kInfinity;
  for (int k = 0; k < kFinePieces; ++k) {
    const Interval piece(-0.5 + static_cast<double>(k) / kFinePieces, -0.5 + static_cast<double>(k + 1) / kFinePieces);
    const Interval middle(piece.middle()), off = piece - middle;
    const Slope v = cone(at(middle)), p = spline_value<2>(u, at(middle));
    const Interval slope_u = scale * (p.d[0] + bend * off), slope_v = cone(at(piece)).d[0];
    const double by_cone = (v.value + scale * p.value + (slope_v + slope_u) * off).lo,
                 by_most = (Interval(square.cone.most) + scale * p.value + slope_u * off).lo;
    if (!(by_cone >= least)) least = by_cone == by_cone ? by_cone : -kInfinity;
    if (!(by_most >= least)) least = by_most == by_most ? by_most : -kInfinity;
  }
  return least;
}

/// The same of a cone that is sampled: at places on the side.
double side_minimum(const Grid<2>& grid, const EndSquare<SampledCone>& square, const Side& side, const Net<2>& u,
                    double sign, double ratio) {
  double least = kInfinity;
  for (int piece = 0; piece <= kPieces; ++piece) {
    const std::array<double, 2> at = side.at(-0.5 + static_cast<double>(piece) / kPieces);
    const Vector2d d = grid.node(side.cell) + grid.h * Vector2d(at[0], at[1]) - square.place;
    const double v = std::min(square.cone.value(d), square.cone.most);
    const double value = v + sign * spline_value<2>(u, at) / ratio;
    if (!(value >= least)) least = value == value ? value : -kInfinity;
  }
  return least;
}

/// Around the end, without a cone.
template <class Cone>
EndSquare<Cone> bare_square(const Grid<2>& grid, const Vector2d& place, bool reversed) {
  EndSquare<Cone> square;
  square.place = place;
  square.middle = grid.place_at(place);
  square.reversed = reversed;
  return square;
}

/// The largest square whose cone, what `make` makes of a reach, is there.
template <class Cone, class Make>
EndSquare<Cone> square_with_cone(EndSquare<Cone> square, const Grid<2>& grid, int k, const Make& make) {
  const Vector2d off = (square.place - grid.node(square.middle)).cwiseAbs();
  for (square.k = std::max(k, kLeastDualRings); square.k >= kLeastDualRings; --square.k) {
    const double half = (square.k + 0.5) * grid.h;
    const std::optional<Cone> cone = make((Vector2d(half, half) + off).norm());
    square.valid = cone.has_value();
    if (!cone) continue;
    square.cone = *cone;
    return square;
  }
  square.k = kLeastDualRings;
  return square;
}

}  // namespace

EndSquare<DualCone> end_square(const CostDual& dual, const Grid<2>& grid, const Vector2d& place, int k, bool reversed) {
  return square_with_cone(bare_square<DualCone>(grid, place, reversed), grid, k,
                          [&](double reach) { return dual_cone(dual, grid.box, place, reach, reversed); });
}

EndSquare<SampledCone> end_square(const CoordinateCost& cost, const Grid<2>& grid, const Vector2d& place, int k,
                                  bool reversed) {
  return square_with_cone(bare_square<SampledCone>(grid, place, reversed), grid, k,
                          [&](double reach) { return sampled_cone(cost, grid.box, place, reach, reversed); });
}

EndSquare<DensityCone> end_square(const CostDensity& density, const Grid<2>& grid, const Vector2d& place, int k,
                                  bool reversed) {
  DensitySquare square = bare_square<DensityCone>(grid, place, reversed);
  for (square.k = std::max(k, kLeastRings); square.k >= kLeastRings; --square.k)
    for (const double wider : {1.6, 2.0, 2.6}) {
      square.valid = make_cone(density, grid, wider, square);
      if (square.valid) return square;
    }
  square.k = kLeastRings;
  square.valid = make_straight_cone(density, grid, square);
  return square;
}

template <class Cone>
double rim_minimum(const Grid<2>& grid, const AllNodes& nodes, const EndSquare<Cone>& square,
                   const std::vector<unsigned char>& searched, const std::vector<double>& u, double sign,
                   double ratio) {
  double least = kInfinity;
  for (int t = -square.k; t <= square.k; ++t)
    for (const std::size_t axis : {0U, 1U})
      for (const int out : {1, -1}) {
        Side side{square.middle, axis, out};
        side.cell[axis] += out * square.k;
        side.cell[side.along()] += t;
        if (!grid.is_cell(side.cell) || !is_left_by(nodes, square, searched, side)) continue;
        const double here = side_minimum(grid, square, side, around(nodes, u, nodes.find(side.cell)), sign, ratio);
        if (!(here >= least)) least = here;
      }
  return least;
}

template double rim_minimum(const Grid<2>&, const AllNodes&, const EndSquare<DensityCone>&,
                            const std::vector<unsigned char>&, const std::vector<double>&, double, double);
template double rim_minimum(const Grid<2>&, const AllNodes&, const EndSquare<DualCone>&,
                            const std::vector<unsigned char>&, const std::vector<double>&, double, double);
template double rim_minimum(const Grid<2>&, const AllNodes&, const EndSquare<SampledCone>&,
                            const std::vector<unsigned char>&, const std::vector<double>&, double, double);

}  // namespace leastcost::bracket
