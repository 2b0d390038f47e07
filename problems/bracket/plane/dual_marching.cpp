// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/dual_marching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "problems/bracket/cubic_minimum.hpp"

namespace leastcost::bracket {
namespace {

/// The nodes around a node, counter-clockwise: neighbours in the list span a triangle with it.
constexpr std::array<std::array<int, 2>, 8> kRing = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// A corner of a triangle: its place in the ring, from the node to it in cells, and its value.
struct Corner {
  std::size_t k;
  double x, y, u;
};

/// What an update at a node needs to know of it.
struct At {
  std::size_t node;
  double density;
  bool back;  ///< costs are those of moves from the node
};

/// Of a dual norm in closed form.
class DualUpdates {
 public:
  explicit DualUpdates(const Level& level) : level_(level) {}

  double least_of_move(const At&) const { return 0; }

  double over_node(const At& at, const Corner& a) const {
    return a.u + at.density * norm_of(at).cost(-a.x * level_.grid.h, -a.y * level_.grid.h);
  }

  /// The value at the node for which H(p) = density, p the gradient on the triangle, where the way it comes from lies
  /// in the triangle; else infinite.
  double over_edge(const At& at, const Corner& a, const Corner& b) const {
    const DualNorm<double> norm = norm_of(at);
    const double density = at.density, base = std::min(a.u, b.u), ua = a.u - base, ub = b.u - base;
    const double det = (a.x * b.y - a.y * b.x) * level_.grid.h;
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
  DualNorm<double> norm_of(const At& at) const {
    return at.back ? level_.duals[at.node].reversed() : level_.duals[at.node];
  }

  const Level& level_;
};

/// Of a norm that is known in some directions: the move that costs least is among those, or near the best of them.
class SampledUpdates {
 public:
  explicit SampledUpdates(const Level& level) : level_(level), sector_(level.norms.directions() / 8) {
    for (int k = 0; k < level.norms.directions(); ++k) {
      const Eigen::Vector2d& e = level.norms.direction(k);
      const auto& [ax, ay] = kRing[static_cast<std::size_t>(k / sector_)];
      const auto& [bx, by] = kRing[static_cast<std::size_t>(k / sector_ + 1) % kRing.size()];
      const double det = ax * by - ay * bx;
      const double a = (e[0] * by - e[1] * bx) / det, b = (ax * e[1] - ay * e[0]) / det;  // e = a A + b B
      moves_.push_back({b / (a + b), 1 / (a + b)});
    }
  }

  /// Every edge is a cell away.
  double least_of_move(const At& at) const { return at.density * level_.grid.h * level_.norms.least_cost(at.node); }

  double over_node(const At& at, const Corner& a) const {
    const double length = std::hypot(a.x, a.y) * level_.grid.h;
    return a.u + at.density * length * towards(at, static_cast<int>(a.k) * sector_);
  }

  /// The cost is convex along the edge: halving by its slope, then a cubic between the directions.
  double over_edge(const At& at, const Corner& a, const Corner& b) const {
    const bool forward = b.k == (a.k + 1) % kRing.size();
    const Corner &first = forward ? a : b, &last = forward ? b : a;
    const int from = static_cast<int>(first.k) * sector_;
    const auto value = [&](int k) {
      if (k == 0) return over_node(at, first);
      if (k == sector_) return over_node(at, last);
      const Move& move = moves_[static_cast<std::size_t>(from + k)];
      return (1 - move.share) * first.u + move.share * last.u +
             at.density * move.length * level_.grid.h * towards(at, from + k);
    };
    int low = -1, best = sector_;  // of all directions in the sector
    while (best - low > 1) {
      const int middle = (low + best) / 2;
      const double here = value(middle), next = value(middle + 1);
      (next < here || !std::isfinite(here) ? low : best) = middle;
    }
    const double least = value(best);
    const int left = best == sector_ || (best > 0 && value(best - 1) < value(best + 1)) ? best - 1 : best;
    const int begin = std::clamp(left - 1, 0, sector_ - 3);
    const std::array<double, 4> around = {value(begin), value(begin + 1), value(begin + 2), value(begin + 3)};
    const double between = cubic_minimum(around, left - begin, left - begin + 1).value;
    return between < least ? between : least;  // infinite ones make no cubic
  }

 private:
  /// To the edge between two neighbours: which part of the edge lies before it, and how far away it is, in cells.
  struct Move {
    double share, length;
  };

  /// Cost per length of the move to the node from that direction.
  double towards(const At& at, int k) const {
    return level_.norms.cost(at.node, at.back ? k : k + level_.norms.directions() / 2);
  }

  const Level& level_;
  const int sector_;
  std::vector<Move> moves_;
};

template <class Updates>
class DualMarch {
 public:
  DualMarch(const Level& level, const Front& front, std::vector<double>& u)
      : level_(level), updates_(level), front_(front), u_(u), is_seed_(u.size(), 0) {
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
    const At at{node, density, back};
    const std::size_t here = (k + 4) % 8;
    const Corner from = corner(here, a, b);
    if (!(from.u < u_[node])) return;
    double best = updates_.over_node(at, from);
    for (const std::size_t beside : {(here + 1) % 8, (here + 7) % 8}) {
      const Corner other = corner(beside, a, b);
      if (std::min(from.u, other.u) + updates_.least_of_move(at) < best && other.u < kInfinity)
        best = std::min(best, updates_.over_edge(at, from, other));
    }
    if (!(best < u_[node] - kNoBetter * std::abs(best)) || !std::isfinite(best)) return;
    u_[node] = best;
    open_.push({best, number});
  }

  Corner corner(std::size_t k, int i, int j) const {
    const int a = i + kRing[k][0], b = j + kRing[k][1];
    const double u = inside(a, b) ? u_[static_cast<std::size_t>(level_.grid.id(a, b))] : kInfinity;
    return {k, static_cast<double>(kRing[k][0]), static_cast<double>(kRing[k][1]), u};
  }

  using Open = std::pair<double, int>;
  const Level& level_;
  const Updates updates_;
  const Front& front_;
  std::vector<double>& u_;
  std::vector<unsigned char> is_seed_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace

void march_dual(const Level& level, const Front& front, std::vector<double>& u, const StopLook& look) {
  if (level.norms.empty())
    DualMarch<DualUpdates>(level, front, u).run(look);
  else
    DualMarch<SampledUpdates>(level, front, u).run(look);
}

}  // namespace leastcost::bracket
