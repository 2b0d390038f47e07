// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/search/dual_medium.hpp"

#include <algorithm>
#include <cmath>

#include "problems/bracket/search/bent_move.hpp"
#include "problems/bracket/search/ring_marching.hpp"

namespace leastcost::bracket {
namespace {

/// Of a dual norm in closed form.
class DualUpdates {
 public:
  DualUpdates(const std::vector<DualNorm<double>>& norms, double h) : norms_(norms), h_(h) {}

  double least_of_move(const At&) const { return 0; }

  double over_node(const At& at, const Corner& a) const {
    return a.u + at.density * norm_of(at).cost(-a.x * h_, -a.y * h_);
  }

  /// The value at the node for which H(p) = density, p the gradient on the triangle, where the way it comes from lies
  /// in the triangle; else infinite.
  double over_edge(const At& at, const Corner& a, const Corner& b) const {
    const DualNorm<double> norm = norm_of(at);
    const double density = at.density, base = std::min(a.u, b.u), ua = a.u - base, ub = b.u - base;
    const double det = (a.x * b.y - a.y * b.x) * h_;
    const double ax = (a.y - b.y) / det, ay = (b.x - a.x) / det;  // p = (ax, ay) u + (bx, by)
    const double bx = (b.y * ua - a.y * ub) / det, by = (a.x * ub - b.x * ua) / det;
    const double nxx = norm.xx - norm.wx * norm.wx, nxy = norm.xy - norm.wx * norm.wy,
                 nyy = norm.yy - norm.wy * norm.wy;
    const double na = nxx * ax + nxy * ay, nb = nxy * ax + nyy * ay;
    const double square = na * ax + nb * ay, half = na * bx + nb * by + density * (norm.wx * ax + norm.wy * ay);
    const double rest = nxx * bx * bx + 2 * nxy * bx * by + nyy * by * by +
                        2 * density * (norm.wx * bx + norm.wy * by) - density * density;
    const double radicand = half * half - square * rest;
    if (!(radicand >= 0)) return kInfinity;
    const double root = std::sqrt(radicand);
    for (const double u : {(root - half) / square, (-root - half) / square}) {
      const double px = ax * u + bx, py = ay * u + by, s = density - norm.wx * px - norm.wy * py;
      if (!(s > 0)) continue;
      const double vx = norm.xx * px + norm.xy * py + s * norm.wx, vy = norm.xy * px + norm.yy * py + s * norm.wy;
      const double from_a = (vy * b.x - vx * b.y) / det, from_b = (vx * a.y - vy * a.x) / det;
      if (from_a >= 0 && from_b >= 0) return base + u;
    }
    return kInfinity;
  }

 private:
  DualNorm<double> norm_of(const At& at) const { return at.back ? norms_[at.node].reversed() : norms_[at.node]; }

  const std::vector<DualNorm<double>>& norms_;
  const double h_;
};

}  // namespace

double DualMedium::cost_near(const End& end, const Grid<2>& grid, const Eigen::Vector2d& x, double) const {
  return bent_move_cost(end, grid, x, [&](const Eigen::Vector2d& at, const Eigen::Vector2d& v) {
    return cost_.dual(at).cost(v[0], v[1]);
  });
}

Eigen::Vector2d DualMedium::Known::steepest(int node, const Eigen::Vector2d& p) const {
  const DualNorm<double>& norm = norms_[static_cast<std::size_t>(node)];
  const double root = std::sqrt(norm.squared(p[0], p[1]));
  return {(norm.xx * p[0] + norm.xy * p[1]) / root + norm.wx, (norm.xy * p[0] + norm.yy * p[1]) / root + norm.wy};
}

void DualMedium::Known::march(const Part<2>& part, const Front& front, std::vector<double>& u,
                              const FastMarching& marching) const {
  const DualUpdates updates(norms_, part.grid.h);
  RingMarch(part.nodes, updates, front, u).run(marching.look());
}

}  // namespace leastcost::bracket
