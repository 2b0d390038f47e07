// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/dual_marching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace leastcost::bracket {
namespace {

/// The nodes around a node, counter-clockwise: neighbours in the list span a triangle with it.
constexpr std::array<std::array<int, 2>, 8> kRing = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// A corner of a triangle: from the node to it in cells, and its value.
struct Corner {
  double x, y, u;
};

/// The value at the node for which H(p) = density, p the gradient on the triangle, where the way it comes from lies in
/// the triangle; else infinite.
double over_edge(const DualNorm<double>& norm, double density, double h, const Corner& a, const Corner& b) {
  const double base = std::min(a.u, b.u), ua = a.u - base, ub = b.u - base;
  const double det = (a.x * b.y - a.y * b.x) * h;
  const double ax = (a.y - b.y) / det, ay = (b.x - a.x) / det;  // p = (ax, ay) u + (bx, by)
  const double bx = (b.y * ua - a.y * ub) / det, by = (a.x * ub - b.x * ua) / det;
  const double nxx = norm.xx - norm.wx * norm.wx, nxy = norm.xy - norm.wx * norm.wy, nyy = norm.yy - norm.wy * norm.wy;
  const double na = nxx * ax + nxy * ay, nb = nxy * ax + nyy * ay;
  const double square = na * ax + nb * ay, half = na * bx + nb * by + density * (norm.wx * ax + norm.wy * ay);
  const double rest = nxx * bx * bx + 2 * nxy * bx * by + nyy * by * by + 2 * density * (norm.wx * bx + norm.wy * by) -
                      density * density;
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

class DualMarch {
 public:
  DualMarch(const Level& level, const Front& front, std::vector<double>& u)
      : level_(level), front_(front), u_(u), is_seed_(u.size(), 0) {
    for (const int seed : front.seeds) {
      is_seed_[static_cast<std::size_t>(seed)] = 1;
      open_.push({u[static_cast<std::size_t>(seed)], seed});
    }
  }

  void run(const StopLook& look) {
    const CellGrid& grid = level_.grid;
    while (!open_.empty()) {
      look.now_and_then();
      const auto [cost, node] = open_.top();
      open_.pop();
      if (cost > u_[static_cast<std::size_t>(node)]) continue;
      const int i = grid.column(node), j = grid.row(node);
      for (std::size_t k = 0; k < kRing.size(); ++k) improve(i, j, k);
    }
  }

 private:
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < level_.grid.stride() && j < level_.grid.ny + 2; }

  /// The node at place k of the ring around (i, j), by what is known at (i, j).
  void improve(int i, int j, std::size_t k) {
    constexpr double kNoBetter = 1e-12;
    const int a = i + kRing[k][0], b = j + kRing[k][1];
    if (!inside(a, b)) return;
    const int number = level_.grid.id(a, b);
    const auto node = static_cast<std::size_t>(number);
    const double density = front_.density[node];
    if (is_seed_[node] || !(density < kInfinity)) return;
    const bool back = front_.reversed != (!front_.sign.empty() && front_.sign[node] < 0);
    const DualNorm<double> norm = back ? level_.duals[node].reversed() : level_.duals[node];
    const std::size_t here = (k + 4) % 8;
    const Corner from = corner(here, a, b);
    if (!(from.u < u_[node])) return;
    const double h = level_.grid.h;
    double best = from.u + density * norm.cost(-from.x * h, -from.y * h);
    for (const std::size_t beside : {(here + 1) % 8, (here + 7) % 8}) {
      const Corner other = corner(beside, a, b);
      if (other.u < kInfinity) best = std::min(best, over_edge(norm, density, h, from, other));
    }
    if (!(best < u_[node] - kNoBetter * std::abs(best)) || !std::isfinite(best)) return;
    u_[node] = best;
    open_.push({best, number});
  }

  Corner corner(std::size_t k, int i, int j) const {
    const int a = i + kRing[k][0], b = j + kRing[k][1];
    const double u = inside(a, b) ? u_[static_cast<std::size_t>(level_.grid.id(a, b))] : kInfinity;
    return {static_cast<double>(kRing[k][0]), static_cast<double>(kRing[k][1]), u};
  }

  using Open = std::pair<double, int>;
  const Level& level_;
  const Front& front_;
  std::vector<double>& u_;
  std::vector<unsigned char> is_seed_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace

void march_dual(const Level& level, const Front& front, std::vector<double>& u, const StopLook& look) {
  DualMarch(level, front, u).run(look);
}

}  // namespace leastcost::bracket
