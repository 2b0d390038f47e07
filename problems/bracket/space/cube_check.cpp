// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/cube_check.hpp"

#include <algorithm>
#include <cmath>

#include "problems/bracket/gradient_nets.hpp"

namespace leastcost::bracket {
namespace {

/// The nets of a gradient and of what it has to stay below.
struct GradientAndFloor {
  CubeNet x, y, z, floor;

  GradientAndFloor half(std::size_t axis, bool upper) const {
    return {half_of(x, axis, upper), half_of(y, axis, upper), half_of(z, axis, upper), half_of(floor, axis, upper)};
  }
};

/// Ratios of control vectors to the floor, in the units of the nets: gradient times side.
struct CubeComparison {
  double side, slack;
  const CubeRules& rules;

  double whole(const GradientAndFloor& nets) const {
    double worst = 0, least = kInfinity;
    for (std::size_t k = 0; k < 27; ++k) {
      if (rules.dropped >> k & 1U) continue;
      const double floor = nets.floor[k], x = nets.x[k], y = nets.y[k], z = nets.z[k];
      const double squared = (x * x + y * y + z * z) / (floor * floor);
      worst = larger_or_nan(worst, squared);
      least = floor >= least ? least : floor;
    }
    const double ratio = (std::sqrt(worst) * (1 + 8 * kEps) + slack / least) / side;
    return least > 0 && ratio < kInfinity ? ratio : kInfinity;
  }

  double proved(const GradientAndFloor& nets, int halvings) const {
    constexpr double kHopeless = 1.1;  // halves do not help where it is the gradient itself that is too long
    const double as_it_is = whole(nets);
    if (as_it_is <= 1 || halvings == 0 || !(as_it_is < kHopeless)) return as_it_is;
    double worst = 0;
    for (const bool up : {false, true}) {
      const GradientAndFloor layer = nets.half(2, up);
      for (const bool back : {false, true}) {
        const GradientAndFloor column = layer.half(1, back);
        for (const bool right : {false, true}) worst = std::max(worst, proved(column.half(0, right), halvings - 1));
      }
    }
    return std::min(worst, as_it_is);
  }
};

/// Second derivatives as numbers, and what their intervals leave unsure within half the sides r of a cell.
struct QuadraticPart {
  std::array<double, 6> bend = {};
  double unsure = 0;

  QuadraticPart(const std::array<Interval, 6>& intervals, const Eigen::Vector3d& r) {
    for (std::size_t e = 0; e < 6; ++e) {
      const auto& [a, b] = kSymmetricEntries[e];
      const Ball entry(intervals[e]);
      bend[e] = entry.middle;
      unsure += (a == b ? 0.5 : 1.0) * entry.radius * r[a] * r[b];
    }
  }
};

}  // namespace

SpaceFloor space_floor(const SpaceDensity& density, const Eigen::AlignedBox3d& part) {
  SpaceFloor out;
  if (part.isEmpty()) return out;
  const SpaceDensityEnclosure n = density.enclose_density(part);
  if (!n.is_finite()) return out;
  out.center = part.center();
  const Eigen::Vector3d r = part.sizes() / 2 + 4 * kEps * (part.min().cwiseAbs() + part.max().cwiseAbs());
  const QuadraticPart over_cell(n.bend, r), at_center(n.bend_at_center, r);
  const bool by_cubic = at_center.unsure + n.cubic < over_cell.unsure;
  out.bend = by_cubic ? at_center.bend : over_cell.bend;
  double unsure = by_cubic ? at_center.unsure + n.cubic : over_cell.unsure;
  for (std::size_t k = 0; k < 3; ++k) {
    const Ball slope(n.slope[k]);
    out.slope[static_cast<int>(k)] = slope.middle;
    unsure += slope.radius * r[static_cast<int>(k)];
  }
  out.value = n.value.lo - unsure * (1 + 32 * kEps) - kEps * std::abs(n.value.lo);
  return out;
}

CubeNet SpaceFloor::on_cell(const SpaceGrid& grid, const Place& cell) const {
  const Eigen::Vector3d node = grid.node(cell), off = node - center;
  const double w = grid.h / 2;
  Eigen::Vector3d turned = Eigen::Vector3d::Zero(), sizes = Eigen::Vector3d::Zero();  // H off, and of its terms
  double bends = 0;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [a, b] = kSymmetricEntries[e];
    turned[a] += bend[e] * off[b];
    if (a != b) turned[b] += bend[e] * off[a];
    sizes[a] += std::abs(bend[e]) * (std::abs(off[b]) + w);
    if (a != b) sizes[b] += std::abs(bend[e]) * (std::abs(off[a]) + w);
    bends += std::abs(bend[e]);
  }
  // The polynomial around the node. The centre and the node are known up to rounding of coordinates.
  const Eigen::Vector3d here = slope + turned, largest = slope.cwiseAbs() + sizes;
  const double size = std::abs(value) + largest.dot(off.cwiseAbs() + node.cwiseAbs() + center.cwiseAbs()) +
                      largest.sum() * grid.h + bends * grid.h * grid.h;
  const double base = value + 0.5 * (slope + here).dot(off) - 64 * kEps * size;
  constexpr std::array<double, 3> kAt = {-1, 0, 1}, kBend = {1, -1, 1};
  CubeNet out;
  std::size_t k = 0;
  for (std::size_t z = 0; z < 3; ++z)
    for (std::size_t y = 0; y < 3; ++y)
      for (std::size_t x = 0; x < 3; ++x)
        out[k++] = base + w * (here[0] * kAt[x] + here[1] * kAt[y] + here[2] * kAt[z]) +
                   w * w *
                       (0.5 * (bend[0] * kBend[x] + bend[1] * kBend[y] + bend[2] * kBend[z]) +
                        bend[3] * kAt[x] * kAt[y] + bend[4] * kAt[x] * kAt[z] + bend[5] * kAt[y] * kAt[z]);
  return out;
}

double proved_ratio(const CubeNet& coefficients, double h, double largest, const CubeNet& floor,
                    const CubeRules& rules) {
  const CubeNet along_z = averaged(coefficients, 2), along_y = averaged(coefficients, 1);
  const GradientAndFloor nets = {differenced(averaged(along_z, 1), 0), differenced(averaged(along_z, 0), 1),
                                 differenced(averaged(along_y, 0), 2), floor};
  // Each control vector is the end of at most sixteen sums and averages of numbers up to 2 |u|.
  const double slack = rules.rounding * 64 * kEps * largest;
  return CubeComparison{h, slack, rules}.proved(nets, rules.halvings) * (1 + 64 * rules.rounding * kEps);
}

}  // namespace leastcost::bracket
