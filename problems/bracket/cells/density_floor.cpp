// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/density_floor.hpp"

#include <algorithm>
#include <cmath>

#include "problems/bracket/number_ball.hpp"

namespace leastcost::bracket {
namespace {

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

Net<2> density_floor(const CostDensity& density, const Grid<2>& grid, const Place<2>& cell) {
  Net<2> out = net_of<2>(-kInfinity);
  const Eigen::AlignedBox2d part = grid.cell(cell);
  if (part.isEmpty()) return out;
  const DensityEnclosure n = density.enclose_density(part);
  if (!n.is_finite()) return out;
  const Ball dx(n.dx), dy(n.dy), xx(n.xx), xy(n.xy), yy(n.yy);
  const Eigen::Vector2d half_sides = part.sizes() / 2, off = grid.node(cell) - part.center();
  const double rx = half_sides[0], ry = half_sides[1], w = grid.h / 2;
  const double unsure = n.slack + dx.radius * rx + dy.radius * ry + 0.5 * (xx.radius * rx * rx + yy.radius * ry * ry) +
                        xy.radius * rx * ry;
  // The polynomial around the centre of the whole cell.
  const double cx = dx.middle + xx.middle * off[0] + xy.middle * off[1],
               cy = dy.middle + xy.middle * off[0] + yy.middle * off[1];
  const double value = n.value.lo + 0.5 * ((dx.middle + cx) * off[0] + (dy.middle + cy) * off[1]);
  const double size = std::abs(n.value.lo) +
                      (std::abs(cx) + std::abs(cy) + std::abs(dx.middle) + std::abs(dy.middle)) *
                          (w + std::abs(grid.coordinate(0, cell[0])) + std::abs(grid.coordinate(1, cell[1]))) +
                      (std::abs(xx.middle) + 2 * std::abs(xy.middle) + std::abs(yy.middle)) * w * grid.h;
  const double base = value - unsure * (1 + 16 * kEps) - 64 * kEps * size;
  constexpr std::array<double, 3> kAt = {-1, 0, 1}, kBend = {1, -1, 1};
  for (std::size_t q = 0; q < 3; ++q)
    for (std::size_t p = 0; p < 3; ++p)
      out[3 * q + p] = base + w * (cx * kAt[p] + cy * kAt[q]) +
                       w * w * (0.5 * (xx.middle * kBend[p] + yy.middle * kBend[q]) + xy.middle * kAt[p] * kAt[q]);
  return out;
}

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

Net<3> SpaceFloor::on_cell(const Grid<3>& grid, const Place<3>& cell) const {
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
  Net<3> out;
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

void Floors<3>::add_cell(const SpaceDensity& density, const Grid<3>& grid, const Place<3>& cell, bool together) {
  const Place<3> cube = {(cell[0] - 1) / 2, (cell[1] - 1) / 2, (cell[2] - 1) / 2};
  if (!together) {
    floors_.push_back(space_floor(density, grid.cell(cell)));
  } else if (cube != cube_) {
    const Eigen::Vector3d middle(2 * cube[0] + 1.5, 2 * cube[1] + 1.5, 2 * cube[2] + 1.5);
    floors_.push_back(space_floor(density, grid.cube(middle, 1)));
    cube_ = cube;
  }
  floor_of_.push_back(static_cast<int>(floors_.size()) - 1);
}

}  // namespace leastcost::bracket
