// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/end_region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <leastcost/framework/numbers/dual.hpp>
#include "problems/bracket/cone_bound.hpp"

namespace leastcost::bracket {
namespace {

using Eigen::Vector2d;

constexpr double kSafety = 1 + 1e-12;
constexpr int kLeastRings = 1, kLeastDualRings = 2;
constexpr int kPieces = 16;  ///< per side of a cell on the rim

double radius_of(const Interval& x) { return std::max(x.hi - x.middle(), x.middle() - x.lo); }

/// Calls f with small parts of a part of the box, as long as it says true; whether it always did.
template <class F>
bool for_parts_of(const Eigen::AlignedBox2d& box, const F& f) {
  constexpr int kParts = 8;
  for (int q = 0; q < kParts; ++q)
    for (int p = 0; p < kParts; ++p) {
      const auto at = [&](int i, int j) {
        return Vector2d(box.min() + box.sizes().cwiseProduct(Vector2d(i, j)) / kParts);
      };
      // Corners are computed alike for the parts on both sides.
      Eigen::AlignedBox2d part(at(p, q), at(p + 1, q + 1));
      if (p + 1 == kParts) part.max()[0] = box.max()[0];
      if (q + 1 == kParts) part.max()[1] = box.max()[1];
      if (!f(part)) return false;
    }
  return true;
}

/// The largest K with which -d'H d <= K |d|^2 for the second derivatives H in a part of the box, from small parts of
/// it; infinite where nothing is known.
double curvature_bound(const CostDensity& density, const Eigen::AlignedBox2d& box) {
  double worst = 0;
  const bool known = for_parts_of(box, [&](const Eigen::AlignedBox2d& part) {
    const DensityEnclosure n = density.enclose_density(part);
    const double a = n.xx.lo, b = n.yy.lo, c = n.xy.magnitude();
    worst = std::max(worst, (std::hypot((a - b) / 2, c) - (a + b) / 2) * kSafety + 1e-14 * (std::abs(a) + std::abs(b)));
    return n.is_finite() && n.slack == 0;
  });
  return known ? worst : kInfinity;
}

/// Fills the cone for an S2 that is `wider` times as wide as S; false where its conditions fail.
bool make_cone(const CostDensity& density, const CellGrid& grid, double wider, EndRegion& region) {
  const double inner = (region.k + 0.5) * grid.h, outer = wider * inner + grid.h;
  const Vector2d off = (region.place - grid.node(region.ci, region.cj)).cwiseAbs();
  const double to_rim = (outer - off.maxCoeff()) / kSafety;
  const double reach = (Vector2d(outer, outer) + off).norm() * kSafety,
               inner_reach = (Vector2d(inner, inner) + off).norm() * kSafety;
  const DensityEnclosure at = density.enclose_density({region.place, region.place});
  if (!at.is_finite() || at.slack != 0) return false;
  region.gx = at.dx.middle();
  region.gy = at.dy.middle();
  const double unsure = (radius_of(at.dx) + radius_of(at.dy)) * reach * kSafety;
  region.n0 = at.value.lo - unsure;
  const double g = std::hypot(region.gx, region.gy) * kSafety;
  const double bend = curvature_bound(density, grid.cell(region.ci, region.cj, outer / grid.h - 0.5));
  region.c = cubic_of_cone(region.n0, g, bend, reach);
  if (!std::isfinite(region.c)) return false;
  const ConeBound cone = {region.n0, g, region.c};
  const double largest = inner_reach * (region.n0 + g * inner_reach / 2);
  return cone_rises(cone, reach) && cone_at_least(cone, to_rim) > largest * kSafety;
}

/// The least a density has in a part of the box, from its enclosure there.
double least_within(const DensityEnclosure& n, const Eigen::AlignedBox2d& part) {
  const Vector2d r = part.sizes() / 2 + 4 * kEps * (part.min().cwiseAbs() + part.max().cwiseAbs());
  const Interval x(-r[0], r[0]), y(-r[1], r[1]), half(0.5);
  return (n.value + n.dx * x + n.dy * y + half * (n.xx * square(x) + n.yy * square(y)) + n.xy * x * y).lo;
}

/// A cone that rises by the least density in S2, where the other one fails because n is bent too much: it loses of the
/// second order in the width of S, which does on coarse grids.
bool make_straight_cone(const CostDensity& density, const CellGrid& grid, EndRegion& region) {
  constexpr double kWider = 1.6;
  const double inner = (region.k + 0.5) * grid.h, outer = kWider * inner + grid.h;
  const Vector2d off = (region.place - grid.node(region.ci, region.cj)).cwiseAbs();
  const double to_rim = (outer - off.maxCoeff()) / kSafety,
               inner_reach = (Vector2d(inner, inner) + off).norm() * kSafety;
  region.gx = region.gy = region.c = 0;
  region.n0 = kInfinity;
  const bool known = for_parts_of(grid.cell(region.ci, region.cj, outer / grid.h - 0.5), [&](const auto& part) {
    const DensityEnclosure n = density.enclose_density(part);
    region.n0 = std::min(region.n0, least_within(n, part));
    return n.is_finite() && n.slack == 0;
  });
  return known && region.n0 > 0 && to_rim > inner_reach * kSafety;
}

/// A side of a cell on the rim: its end points in units of the cell, and the cells beyond it.
struct Side {
  int i, j, out_i, out_j;  ///< the cell, and the step to the cell beyond
};

bool is_left_by(const CellGrid& grid, const EndRegion& region, const std::vector<unsigned char>& searched,
                const Side& side) {
  for (int along = -1; along <= 1; ++along) {
    const int i = side.i + side.out_i + (side.out_i == 0 ? along : 0),
              j = side.j + side.out_j + (side.out_j == 0 ? along : 0);
    if (grid.is_cell(i, j) && !region.holds(i, j) && searched[static_cast<std::size_t>(grid.id(i, j))]) return true;
  }
  return false;
}

/// On one side: least value at the ends of its pieces, less what the function can fall between them.
double side_minimum(const CellGrid& grid, const EndRegion& region, const Side& side, const std::vector<double>& u,
                    double sign, double ratio) {
  const int stride = grid.stride();
  const auto node = static_cast<std::size_t>(grid.id(side.i, side.j));
  const Interval h(grid.h), x_node = Interval(grid.x0) + (Interval(side.i) - 0.5) * h,
                            y_node = Interval(grid.y0) + (Interval(side.j) - 0.5) * h;
  double least = kInfinity;
  for (int piece = 0; piece <= kPieces; ++piece) {
    const double t = -0.5 + static_cast<double>(piece) / kPieces;
    const Interval a(side.out_i == 0 ? t : 0.5 * side.out_i), b(side.out_j == 0 ? t : 0.5 * side.out_j);
    const Interval v =
        region.cone(x_node + a * h - Interval(region.place[0]), y_node + b * h - Interval(region.place[1]));
    const double value = (v + Interval(sign) * spline_value<Interval>(u, stride, node, a, b) / Interval(ratio)).lo;
    if (!(value >= least)) least = value;
  }
  // Second derivative along the side: of v at most n0 / distance + 3 |g| / 2, of u constant.
  const double away = std::min((region.k + 0.5) * grid.h - std::abs(region.place[0] - grid.x(region.ci)),
                               (region.k + 0.5) * grid.h - std::abs(region.place[1] - grid.y(region.cj)));
  const int step = side.out_i == 0 ? 1 : stride, out = side.out_i == 0 ? stride * side.out_j : side.out_i;
  const auto difference = [&](long at) {
    const auto k = [&](long d) { return u[static_cast<std::size_t>(at + d)]; };
    return std::abs(k(step) - 2 * k(0) + k(-step)) + 4e-15 * (std::abs(k(step)) + std::abs(k(0)) + std::abs(k(-step)));
  };
  const double bend_u = std::max(difference(static_cast<long>(node)), difference(static_cast<long>(node) + out));
  const double bend = region.n0 / away + 1.5 * std::hypot(region.gx, region.gy) + bend_u / (grid.h * grid.h * ratio);
  const double length = grid.h / kPieces;
  const double bound = least - length * length / 8 * bend * (1 + 1e-10);
  return bound == bound ? bound : -kInfinity;
}

/// What the second derivative of the spline along a side lies in, in units of the cell.
Interval bend_along(const std::vector<double>& u, int stride, std::size_t node, bool along_y) {
  const long step = along_y ? stride : 1, across = along_y ? 1 : stride;
  Interval out;
  for (int q = -1; q <= 1; ++q) {
    const auto at = [&](long k) {
      return Interval(u[static_cast<std::size_t>(static_cast<long>(node) + q * across + k * step)]);
    };
    const Interval here = (at(1) - at(0)) - (at(0) - at(-1));
    out = q < 0 ? here : hull(out, here);
  }
  return out;
}

/// The same for the cone of a dual norm: on each piece by the value in its middle and the slopes on it.
double dual_side_minimum(const CellGrid& grid, const EndRegion& region, const Side& side, const std::vector<double>& u,
                         double sign, double ratio) {
  using Slope = Dual<Interval, 1>;
  constexpr int kFinePieces = 32;
  const bool along_y = side.out_i != 0;
  const auto node = static_cast<std::size_t>(grid.id(side.i, side.j));
  const Interval h(grid.h), x0 = Interval(grid.x0) + (Interval(side.i) - 0.5) * h - Interval(region.place[0]),
                            y0 = Interval(grid.y0) + (Interval(side.j) - 0.5) * h - Interval(region.place[1]);
  const Interval scale = Interval(sign) / Interval(ratio), bend = bend_along(u, grid.stride(), node, along_y);
  const auto at = [&](const Interval& t, const auto& f) {
    const Slope along(t, {Interval(1)});
    return along_y ? f(Slope(0.5 * side.out_i), along) : f(along, Slope(0.5 * side.out_j));
  };
  const auto cone = [&](const Slope& a, const Slope& b) {
    return region.dual->value<Slope>(Slope(x0, {}) + a * Slope(grid.h), Slope(y0, {}) + b * Slope(grid.h));
  };
  const auto spline = [&](const Slope& a, const Slope& b) { return spline_value<Slope>(u, grid.stride(), node, a, b); };
  double least = kInfinity;
  for (int k = 0; k < kFinePieces; ++k) {
    const Interval piece(-0.5 + static_cast<double>(k) / kFinePieces, -0.5 + static_cast<double>(k + 1) / kFinePieces);
    const Interval middle(piece.middle()), off = piece - middle;
    const Slope v = at(middle, cone), p = at(middle, spline);
    const Interval slope_u = scale * (p.d[0] + bend * off), slope_v = at(piece, cone).d[0];
    const double by_cone = (v.value + scale * p.value + (slope_v + slope_u) * off).lo,
                 by_most = (Interval(region.dual->most) + scale * p.value + slope_u * off).lo;
    if (!(by_cone >= least)) least = by_cone == by_cone ? by_cone : -kInfinity;
    if (!(by_most >= least)) least = by_most == by_most ? by_most : -kInfinity;
  }
  return least;
}

/// The same of a cone that is sampled: at places on the side.
double sampled_side_minimum(const CellGrid& grid, const EndRegion& region, const Side& side,
                            const std::vector<double>& u, double sign, double ratio) {
  const auto node = static_cast<std::size_t>(grid.id(side.i, side.j));
  double least = kInfinity;
  for (int piece = 0; piece <= kPieces; ++piece) {
    const double t = -0.5 + static_cast<double>(piece) / kPieces;
    const Vector2d at(side.out_i == 0 ? t : 0.5 * side.out_i, side.out_j == 0 ? t : 0.5 * side.out_j);
    const Vector2d d = grid.node(side.i, side.j) + grid.h * at - region.place;
    const double v = std::min(region.sampled->value(d), region.sampled->most);
    const double value = v + sign * spline_value<double>(u, grid.stride(), node, at[0], at[1]) / ratio;
    if (!(value >= least)) least = value == value ? value : -kInfinity;
  }
  return least;
}

double side_bound(const CellGrid& grid, const EndRegion& region, const Side& side, const std::vector<double>& u,
                  double sign, double ratio) {
  if (region.sampled) return sampled_side_minimum(grid, region, side, u, sign, ratio);
  return region.dual ? dual_side_minimum(grid, region, side, u, sign, ratio)
                     : side_minimum(grid, region, side, u, sign, ratio);
}

/// The largest region whose cone, of what `make` makes of a reach, is there.
template <class Make>
EndRegion region_with_cone(const CellGrid& grid, const Vector2d& place, int k, bool reversed, const Make& make) {
  EndRegion region;
  region.place = place;
  region.reversed = reversed;
  region.ci = grid.column_at(place[0]);
  region.cj = grid.row_at(place[1]);
  const Vector2d off = (place - grid.node(region.ci, region.cj)).cwiseAbs();
  for (region.k = std::max(k, kLeastDualRings); region.k >= kLeastDualRings; --region.k) {
    const double half = (region.k + 0.5) * grid.h;
    region.valid = make((Vector2d(half, half) + off).norm(), region);
    if (region.valid) return region;
  }
  region.k = kLeastDualRings;
  return region;
}

}  // namespace

EndRegion end_region(const CostDual& dual, const CellGrid& grid, const Vector2d& place, int k, bool reversed) {
  return region_with_cone(grid, place, k, reversed, [&](double reach, EndRegion& region) {
    region.dual = dual_cone(dual, grid.box, place, reach, reversed);
    return region.dual.has_value();
  });
}

EndRegion end_region(const CoordinateCost& cost, const CellGrid& grid, const Vector2d& place, int k, bool reversed) {
  return region_with_cone(grid, place, k, reversed, [&](double reach, EndRegion& region) {
    region.sampled = sampled_cone(cost, grid.box, place, reach, reversed);
    return region.sampled.has_value();
  });
}

EndRegion end_region(const CostDensity& density, const CellGrid& grid, const Vector2d& place, int k) {
  EndRegion region;
  region.place = place;
  region.ci = grid.column_at(place[0]);
  region.cj = grid.row_at(place[1]);
  for (region.k = std::max(k, kLeastRings); region.k >= kLeastRings; --region.k)
    for (const double wider : {1.6, 2.0, 2.6}) {
      region.valid = make_cone(density, grid, wider, region);
      if (region.valid) return region;
    }
  region.k = kLeastRings;
  region.valid = make_straight_cone(density, grid, region);
  return region;
}

double rim_minimum(const CellGrid& grid, const EndRegion& region, const std::vector<unsigned char>& searched,
                   const std::vector<double>& u, double sign, double ratio) {
  double least = kInfinity;
  for (int t = -region.k; t <= region.k; ++t) {
    const std::array<Side, 4> sides = {{{region.ci + region.k, region.cj + t, 1, 0},
                                        {region.ci - region.k, region.cj + t, -1, 0},
                                        {region.ci + t, region.cj + region.k, 0, 1},
                                        {region.ci + t, region.cj - region.k, 0, -1}}};
    for (const Side& side : sides) {
      if (!grid.is_cell(side.i, side.j) || !is_left_by(grid, region, searched, side)) continue;
      const double here = side_bound(grid, region, side, u, sign, ratio);
      if (!(here >= least)) least = here;
    }
  }
  return least;
}

}  // namespace leastcost::bracket
