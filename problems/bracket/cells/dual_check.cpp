// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/dual_check.hpp"

#include <algorithm>
#include <cmath>

#include "problems/bracket/number_ball.hpp"

namespace leastcost::bracket {
namespace {

Quadratic quadratic_of(const CostDual::Jet& f, const Eigen::AlignedBox2d& part, const Grid<2>& grid,
                       const Place<2>& cell) {
  const Ball xx(f.d(0, 0)), xy(f.d(0, 1)), yy(f.d(1, 1));
  const Eigen::Vector2d half_sides = part.sizes() / 2;
  const double rx = half_sides[0] * (1 + 4 * kEps), ry = half_sides[1] * (1 + 4 * kEps), w = grid.h / 2;
  // From the centre of the part to the node, and the polynomial there.
  const Interval ox = Interval(grid.corner[0]) + (Interval(cell[0]) - 0.5) * Interval(grid.h) -
                      Interval(Interval(part.min()[0], part.max()[0]).middle()),
                 oy = Interval(grid.corner[1]) + (Interval(cell[1]) - 0.5) * Interval(grid.h) -
                      Interval(Interval(part.min()[1], part.max()[1]).middle());
  const Interval gx = f.d_at_center(0), gy = f.d_at_center(1), hxx(xx.middle), hxy(xy.middle), hyy(yy.middle);
  const Ball x(gx + hxx * ox + hxy * oy), y(gy + hxy * ox + hyy * oy),
      v(f.value_at_center() + gx * ox + gy * oy +
        Interval(0.5) * (hxx * square(ox) + Interval(2) * hxy * ox * oy + hyy * square(oy)));
  Quadratic q{v.middle, x.middle, y.middle, xx.middle, xy.middle, yy.middle, 0, 0};
  q.size = std::abs(q.v) + w * (std::abs(q.x) + std::abs(q.y)) +
           0.5 * w * w * (std::abs(q.xx) + 2 * std::abs(q.xy) + std::abs(q.yy));
  const double unsure =
      v.radius + w * (x.radius + y.radius) + 0.5 * (xx.radius * rx * rx + yy.radius * ry * ry) + xy.radius * rx * ry;
  q.slack = unsure * (1 + 1e-12) + 128 * kEps * q.size;
  return q;
}

using Gradient = std::array<Net<2>, 2>;

/// A part of the cell: its middle from the node on, and half its side.
struct Part {
  double x, y, half;
};

double value_at(const Quadratic& q, const Part& at) {
  return q.v + q.x * at.x + q.y * at.y + 0.5 * (q.xx * at.x * at.x + q.yy * at.y * at.y) + q.xy * at.x * at.y;
}
double slope_x(const Quadratic& q, const Part& at) { return q.x + q.xx * at.x + q.xy * at.y; }
double slope_y(const Quadratic& q, const Part& at) { return q.y + q.xy * at.x + q.yy * at.y; }

/// H at a fixed gradient g, as a function of the place, from above: sqrt(Q) <= s / 2 + Q / (2 s) for every s > 0.
struct Above {
  double value, x, y, bend;
};

/// For fixed x, H is convex in the gradient; the gradient is a convex combination of the control vectors g_k with the
/// weights B_k(x), and the sum of B_k(x) (xi_k - x) is zero for their places xi_k. Hence
///
///     H(x, grad u) <= max over k of H(c, g_k) + D.(xi_k - c) + max over x of H(x, g_k) - H(c, g_k) - D.(x - c),
///
/// c the middle of the part and D any vector: here the slope of H at the middle control vector.
struct DualComparison {
  const DualCell& cell;
  double side, sign, slack;
  const CheckRules<2>& rules;
  const BlockedParts& blocked;

  Above above(double gx, double gy, const Part& at) const {
    constexpr double kLeast = 0.05;  // what is far below 1 need not be sharp
    const double a = gx * gx, b = 2 * gx * gy, c = gy * gy, size = std::abs(b);
    const double unsure = a * cell.xx.slack + size * cell.xy.slack + c * cell.yy.slack;
    const double q = a * value_at(cell.xx, at) + b * value_at(cell.xy, at) + c * value_at(cell.yy, at) + unsure;
    const double s = std::sqrt(std::max(q, kLeast * kLeast)), t = 0.5 / s;
    const auto mixed = [&](double xx, double xy, double yy, double wx, double wy) {
      return t * (a * xx + b * xy + c * yy) + gx * wx + gy * wy;
    };
    Above out{0, 0, 0, 0};
    out.value = 0.5 * s + t * q + gx * value_at(cell.wx, at) + gy * value_at(cell.wy, at) +
                std::abs(gx) * cell.wx.slack + std::abs(gy) * cell.wy.slack;
    out.value += 8 * kEps * (s + t * std::abs(q));
    out.x = mixed(slope_x(cell.xx, at), slope_x(cell.xy, at), slope_x(cell.yy, at), slope_x(cell.wx, at),
                  slope_x(cell.wy, at));
    out.y = mixed(slope_y(cell.xx, at), slope_y(cell.xy, at), slope_y(cell.yy, at), slope_y(cell.wx, at),
                  slope_y(cell.wy, at));
    const double xx = mixed(cell.xx.xx, cell.xy.xx, cell.yy.xx, cell.wx.xx, cell.wy.xx),
                 xy = mixed(cell.xx.xy, cell.xy.xy, cell.yy.xy, cell.wx.xy, cell.wy.xy),
                 yy = mixed(cell.xx.yy, cell.xy.yy, cell.yy.yy, cell.wx.yy, cell.wy.yy);
    out.bend = at.half * at.half * (0.5 * (std::max(xx, 0.0) + std::max(yy, 0.0)) + std::abs(xy));
    return out;
  }

  /// `least`: of what halves of the part may prove at best.
  double whole(const Gradient& g, const Part& at, double& least) const {
    const double scale = sign / side;
    const Above middle = above(scale * g[0][4], scale * g[1][4], at);
    double worst = 0;
    least = middle.value;
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t p = 0; p < 3; ++p) {
        if (rules.dropped >> (3 * q + p) & 1U) continue;
        const Above here = above(scale * g[0][3 * q + p], scale * g[1][3 * q + p], at);
        const double px = static_cast<double>(p) - 1, py = static_cast<double>(q) - 1;
        const double bound = here.value + at.half * (px * middle.x + py * middle.y) +
                             at.half * (std::abs(here.x - middle.x) + std::abs(here.y - middle.y)) + here.bend;
        worst = larger_or_nan(worst, bound);
        if (p != 1 && q != 1) least = std::max(least, here.value + at.half * (px * here.x + py * here.y));
      }
    const double ratio = worst + slack;
    return ratio < kInfinity ? ratio : kInfinity;
  }

  double proved(const Gradient& g, const Part& at, const CellPart<2>& part) const {
    constexpr double kHopeless = 1.1;  // halves do not help where it is the gradient itself that is too long
    constexpr double kWorthWhile = 0.2;
    if (blocked.any() && blocked.holds(part)) return 0;
    double least = 0;
    const double as_it_is = whole(g, at, least);
    const bool little = as_it_is - least < kWorthWhile * (as_it_is - 1);
    if (as_it_is <= 1) return as_it_is;
    if (blocked.any() ? part.level == BlockedParts::kLevels
                      : part.level == rules.halvings || little || !(as_it_is < kHopeless))
      return as_it_is;
    double worst = 0;
    const double half = 0.5 * at.half;
    for_halves<2>(g, [&](const Gradient& of_half, const Place<2>& upper) {
      const Part quarter{at.x + (upper[0] != 0 ? half : -half), at.y + (upper[1] != 0 ? half : -half), half};
      worst = std::max(worst, proved(of_half, quarter, part.half(upper)));
    });
    return std::min(worst, as_it_is);
  }
};

}  // namespace

DualCell dual_cell(const CostDual& dual, const Grid<2>& grid, const Place<2>& cell) {
  const Eigen::AlignedBox2d part = grid.cell(cell);
  if (part.isEmpty()) {
    DualCell none;
    none.xx.slack = none.yy.slack = kInfinity;
    return none;
  }
  const DualNorm<CostDual::Jet> f = dual.enclose_cell(part);
  const auto of = [&](const CostDual::Jet& x) { return quadratic_of(x, part, grid, cell); };
  return {of(f.xx), of(f.xy), of(f.yy), of(f.wx), of(f.wy)};
}

double proved_dual_ratio(const Net<2>& coefficients, double h, double largest, double sign, const DualCell& cell,
                         const CheckRules<2>& rules, const BlockedParts& blocked) {
  // Each control vector is the end of at most sixteen sums and averages of numbers up to 2 |u|; H is Lipschitz.
  const auto most = [](const Quadratic& q) { return q.size + q.slack; };
  const double lipschitz = std::sqrt(most(cell.xx) + most(cell.yy)) + most(cell.wx) + most(cell.wy);
  const double slack = rules.rounding * 1.5 * 64 * kEps * largest / h * lipschitz;
  return DualComparison{cell, h, sign, slack, rules, blocked}.proved(gradient_nets<2>(coefficients), {0, 0, h / 2},
                                                                     {}) *
         (1 + 64 * rules.rounding * kEps);
}

}  // namespace leastcost::bracket
