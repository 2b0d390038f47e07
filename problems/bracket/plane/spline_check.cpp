// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/spline_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/bracket/gradient_nets.hpp"

namespace leastcost::bracket {
namespace {

/// The three nets of a gradient and of what it has to stay below.
struct Nets {
  Net x, y, floor;
};

/// Squared ratios of control vectors, in the units of the nets: gradient times side.
struct Comparison {
  double side, slack;
  const CheckRules& rules;
  const BlockedParts& blocked;

  double whole(const Nets& nets) const {
    double worst = 0, least = kInfinity;
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t p = 0; p < 3; ++p) {
        if (rules.dropped >> (3 * q + p) & 1U) continue;
        const double floor = nets.floor[q][p], x = nets.x[q][p], y = nets.y[q][p];
        const double squared = (x * x + y * y) / (floor * floor);
        worst = larger_or_nan(worst, squared);
        least = floor >= least ? least : floor;
      }
    const double ratio = (std::sqrt(worst) * (1 + 8 * kEps) + slack / least) / side;
    return least > 0 && ratio < kInfinity ? ratio : kInfinity;
  }

  double proved(const Nets& nets, const CellPart& part) const {
    constexpr double kHopeless = 1.1;  // halves do not help where it is the gradient itself that is too long
    if (blocked.any() && blocked.holds(part)) return 0;
    const double as_it_is = whole(nets);
    if (as_it_is <= 1) return as_it_is;
    if (blocked.any() ? part.level == BlockedParts::kLevels : part.level == rules.halvings || !(as_it_is < kHopeless))
      return as_it_is;
    double worst = 0;
    for (const bool upper : {false, true}) {
      const Nets rows = {half_of_rows(nets.x, upper), half_of_rows(nets.y, upper), half_of_rows(nets.floor, upper)};
      for (const bool right : {false, true})
        worst = std::max(worst, proved({half_of_columns(rows.x, right), half_of_columns(rows.y, right),
                                        half_of_columns(rows.floor, right)},
                                       part.half(right, upper)));
    }
    return std::min(worst, as_it_is);
  }
};

}  // namespace

Net density_floor(const CostDensity& density, const CellGrid& grid, int i, int j) {
  Net out;
  for (auto& row : out) row.fill(-kInfinity);
  const Eigen::AlignedBox2d part = grid.cell(i, j);
  if (part.isEmpty()) return out;
  const DensityEnclosure n = density.enclose_density(part);
  if (!n.is_finite()) return out;
  const Ball dx(n.dx), dy(n.dy), xx(n.xx), xy(n.xy), yy(n.yy);
  const Eigen::Vector2d half_sides = part.sizes() / 2, off = grid.node(i, j) - part.center();
  const double rx = half_sides[0], ry = half_sides[1], w = grid.h / 2;
  const double unsure = n.slack + dx.radius * rx + dy.radius * ry + 0.5 * (xx.radius * rx * rx + yy.radius * ry * ry) +
                        xy.radius * rx * ry;
  // The polynomial around the centre of the whole cell.
  const double cx = dx.middle + xx.middle * off[0] + xy.middle * off[1],
               cy = dy.middle + xy.middle * off[0] + yy.middle * off[1];
  const double value = n.value.lo + 0.5 * ((dx.middle + cx) * off[0] + (dy.middle + cy) * off[1]);
  const double size = std::abs(n.value.lo) +
                      (std::abs(cx) + std::abs(cy) + std::abs(dx.middle) + std::abs(dy.middle)) *
                          (w + std::abs(grid.x(i)) + std::abs(grid.y(j))) +
                      (std::abs(xx.middle) + 2 * std::abs(xy.middle) + std::abs(yy.middle)) * w * grid.h;
  const double base = value - unsure * (1 + 16 * kEps) - 64 * kEps * size;
  constexpr std::array<double, 3> kAt = {-1, 0, 1}, kBend = {1, -1, 1};
  for (std::size_t q = 0; q < 3; ++q)
    for (std::size_t p = 0; p < 3; ++p)
      out[q][p] = base + w * (cx * kAt[p] + cy * kAt[q]) +
                  w * w * (0.5 * (xx.middle * kBend[p] + yy.middle * kBend[q]) + xy.middle * kAt[p] * kAt[q]);
  return out;
}

Net value_net(const std::vector<double>& u, int stride, std::size_t node) {
  Net net;
  const auto at = [&](int p, int q) { return u[static_cast<std::size_t>(static_cast<long>(node) + q * stride + p)]; };
  Net rows;
  for (int q = -1; q <= 1; ++q)
    rows[static_cast<std::size_t>(q + 1)] = {0.5 * (at(-1, q) + at(0, q)), at(0, q), 0.5 * (at(0, q) + at(1, q))};
  for (std::size_t k = 0; k < 3; ++k) {
    net[0][k] = 0.5 * (rows[0][k] + rows[1][k]);
    net[1][k] = rows[1][k];
    net[2][k] = 0.5 * (rows[1][k] + rows[2][k]);
  }
  return net;
}

double proved_ratio(const std::vector<double>& u, int stride, std::size_t node, double h, double largest,
                    const Net& floor, const CheckRules& rules, const BlockedParts& blocked) {
  Nets nets;
  gradient_nets(u, stride, node, nets.x, nets.y);
  nets.floor = floor;
  // Each control vector is the end of at most sixteen sums and averages of numbers up to 2 |u|.
  const double slack = rules.rounding * 64 * kEps * largest;
  return Comparison{h, slack, rules, blocked}.proved(nets, {}) * (1 + 64 * rules.rounding * kEps);
}

}  // namespace leastcost::bracket
