// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/end_ball.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "problems/bracket/cone_bound.hpp"
#include "problems/bracket/number_ball.hpp"

namespace leastcost::bracket {
namespace {

using Eigen::Vector3d;

constexpr double kMore = 1 + 1e-12;  ///< for rounding

/// The largest K with which -d'H d <= K |d|^2 for a matrix of these intervals: of its middle, by Weyl's inequality.
double largest_fall(const std::array<Interval, 6>& bend) {
  Eigen::Matrix3d middle;
  double radii = 0;  // squares, of the matrix of radii
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [a, b] = kSymmetricEntries[e];
    const Ball entry(bend[e]);
    middle(a, b) = middle(b, a) = -entry.middle;
    radii += (a == b ? 1 : 2) * entry.radius * entry.radius;
  }
  if (!middle.allFinite() || !std::isfinite(radii)) return kInfinity;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(middle, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2] + std::sqrt(radii) * kMore + 1e-12 * middle.norm();
}

/// The same over a part of the box, from small parts of it; infinite where nothing is known.
double curvature_in(const SpaceDensity& density, const Eigen::AlignedBox3d& box) {
  constexpr int kParts = 4;
  double worst = 0;
  const bool known = for_parts_of<3>(box, kParts, [&](const Eigen::AlignedBox3d& part) {
    const SpaceDensityEnclosure n = density.enclose_density(part);
    if (n.is_finite()) worst = std::max(worst, largest_fall(n.bend) * kMore);
    return n.is_finite();
  });
  return known ? worst : kInfinity;
}

/// The farthest that a place of S is from the end.
double reach_of(const Grid<3>& grid, const EndBall& ball) {
  const double off = (ball.place - grid.node(ball.middle)).norm();
  return ((ball.k + 0.5 + std::sqrt(0.75)) * grid.h + off) * kMore;
}

/// The cone within `reach` of the end; not valid where there is none.
EndBall cone_within(const SpaceDensity& density, const Grid<3>& grid, EndBall ball, double reach) {
  ball.valid = false;
  const SpaceDensityEnclosure at = density.enclose_density({ball.place, ball.place});
  if (!at.is_finite()) return ball;
  double unsure = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Ball slope(at.slope[k]);
    ball.slope[static_cast<int>(k)] = slope.middle;
    unsure += slope.radius * reach * kMore;
  }
  ball.n0 = at.value.lo - unsure;
  const double g = ball.slope.norm() * kMore;
  const Vector3d half = Vector3d::Constant(reach * kMore);
  const Eigen::AlignedBox3d around = Eigen::AlignedBox3d(ball.place - half, ball.place + half).intersection(grid.box);
  ball.c = cubic_of_cone(ball.n0, g, curvature_in(density, around), reach);
  if (!std::isfinite(ball.c) || !cone_rises({ball.n0, g, ball.c}, reach)) return ball;
  ball.most = cone_at_least({ball.n0, g, ball.c}, reach) - 1e-12 * ball.n0 * reach;
  ball.valid = true;
  return ball;
}

/// A side of a cell on the rim, and the step along `axis` to the cell beyond.
struct RimSide {
  Place<3> cell;
  std::size_t axis;
  int out;

  /// A cell that touches it: of the cell's own layer (0) or of the one beyond (1).
  Place<3> beside(int layer, int one, int other) const {
    Place<3> p = cell;
    p[axis] += layer * out;
    p[(axis + 1) % 3] += one;
    p[(axis + 2) % 3] += other;
    return p;
  }
};

/// Whether a searched cell outside S touches the side.
bool is_left_by(const NodeSet& nodes, const EndBall& ball, const std::vector<unsigned char>& searched,
                const RimSide& side) {
  for (const int layer : {0, 1})
    for (int one = -1; one <= 1; ++one)
      for (int other = -1; other <= 1; ++other) {
        const Place<3> p = side.beside(layer, one, other);
        if (!ball.holds(p) && searched[static_cast<std::size_t>(nodes.find(p))]) return true;
      }
  return false;
}

/// The least distance of the side from the end, or a little less.
double distance_of(const Grid<3>& grid, const EndBall& ball, const RimSide& side) {
  Vector3d d = (grid.node(side.cell) - ball.place).cwiseAbs();
  for (int k = 0; k < 3; ++k)
    if (k != static_cast<int>(side.axis)) d[k] = std::max(0.0, d[k] - 0.5 * grid.h);
  d[static_cast<int>(side.axis)] = std::abs(grid.node(side.cell)[static_cast<int>(side.axis)] +
                                            0.5 * side.out * grid.h - ball.place[static_cast<int>(side.axis)]);
  return d.norm() * (1 - 1e-9);
}

/// How much the slope of the spline along an axis of the side may change over a unit of the cell: on the side its
/// second derivative is a mean of second differences on the two layers of nodes beside it.
double bend_on_side(const Net<3>& u, const RimSide& side, std::size_t along) {
  const std::size_t step = kNetStep[along];
  double worst = 0;
  for_lines<27>(along, [&](std::size_t at) {
    const auto layer = static_cast<int>(at / kNetStep[side.axis] % 3) - 1;
    if (layer == -side.out) return;
    const double a = u[at], b = u[at + step], c = u[at + 2 * step];
    worst = std::max(worst, std::abs(a - 2 * b + c) + 4e-15 * (std::abs(a) + std::abs(b) + std::abs(c)));
  });
  return worst;
}

/// On one side: least value at the corners of its pieces, less what the function can fall between them.
double side_minimum(const Grid<3>& grid, const EndBall& ball, const RimSide& side, const Net<3>& u, double sign,
                    double ratio) {
  if (!(largest_of(u) < kInfinity)) return -kInfinity;
  constexpr int kPieces = 4;  // along each edge
  const Interval h(grid.h), scale = Interval(sign) / Interval(ratio);
  double least_by_cone = kInfinity, least_by_most = kInfinity;
  for (int q = 0; q <= kPieces; ++q)
    for (int p = 0; p <= kPieces; ++p) {
      std::array<Interval, 3> at, d;
      at[side.axis] = 0.5 * side.out;
      at[(side.axis + 1) % 3] = -0.5 + static_cast<double>(p) / kPieces;
      at[(side.axis + 2) % 3] = -0.5 + static_cast<double>(q) / kPieces;
      for (std::size_t k = 0; k < 3; ++k)
        d[k] = Interval(grid.corner[static_cast<int>(k)]) + (Interval(side.cell[k]) - 0.5) * h + at[k] * h -
               Interval(ball.place[static_cast<int>(k)]);
      const Interval value = scale * spline_value<3>(u, at);
      least_by_cone = std::min(least_by_cone, (ball.cone(d) + value).lo);
      least_by_most = std::min(least_by_most, (Interval(ball.most) + value).lo);
    }
  // Second derivatives along both edges: of v at most n0 / distance + 3 |g| / 2, of u as the second differences.
  const double away = distance_of(grid, ball, side);
  const double bend_v = ball.n0 / away + 1.5 * ball.slope.norm();
  const double bend_u = bend_on_side(u, side, (side.axis + 1) % 3) + bend_on_side(u, side, (side.axis + 2) % 3);
  const double length = grid.h / kPieces, squares = length * length / 8 * (1 + 1e-10);
  const double fall_u = squares * bend_u / (grid.h * grid.h * ratio), fall_v = squares * 2 * bend_v;
  const double bound = std::min(least_by_cone - fall_u - fall_v, least_by_most - fall_u);
  return bound == bound ? bound : -kInfinity;
}

}  // namespace

EndBall end_ball(const SpaceDensity& density, const Grid<3>& grid, const Vector3d& place, int k) {
  EndBall ball;
  ball.place = place;
  ball.middle = grid.place_at(place);
  constexpr double kLittle = 0.9;  // of what is not cut off
  for (ball.k = std::max(k, 1); ball.k >= 1; --ball.k) {
    const double inner = reach_of(grid, ball);
    EndBall best = ball;
    for (const double wider : {1.0, 1.1, 1.2, 1.4, 1.7, 2.2}) {
      const EndBall here = cone_within(density, grid, ball, wider * inner);
      if (here.valid && here.most > best.most) best = here;
      if (best.valid && best.most >= inner * (best.n0 + best.slope.norm() * inner / 2)) return best;
    }
    if (best.valid && (ball.k == 1 || best.most >= kLittle * inner * best.n0)) return best;
  }
  ball.k = 1;
  return ball;
}

double rim_minimum(const Grid<3>& grid, const NodeSet& nodes, const EndBall& ball,
                   const std::vector<unsigned char>& searched, const std::vector<double>& u, double sign,
                   double ratio) {
  double least = kInfinity;
  for (int r = -ball.k; r <= ball.k; ++r)
    for (int q = -ball.k; q <= ball.k; ++q)
      for (int p = -ball.k; p <= ball.k; ++p)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int out : {-1, 1}) {
            const RimSide side{{ball.middle[0] + p, ball.middle[1] + q, ball.middle[2] + r}, axis, out};
            if (!ball.holds(side.cell) || ball.holds(side.beside(1, 0, 0)) || !grid.is_cell(side.cell)) continue;
            if (!is_left_by(nodes, ball, searched, side)) continue;
            const int node = nodes.find(side.cell);
            const bool known = node != nodes.none() && nodes.is_inner(node);
            const double here =
                known ? side_minimum(grid, ball, side, around(nodes, u, node), sign, ratio) : -kInfinity;
            if (!(here >= least)) least = here;
          }
  return least;
}

}  // namespace leastcost::bracket
