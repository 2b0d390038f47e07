// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "problems/bracket/search/medium.hpp"
#include "problems/bracket/stopped.hpp"

namespace leastcost::bracket {

/// The nodes around a node, counter-clockwise: neighbours in the list span a triangle with it.
inline constexpr std::array<std::array<int, 2>, 8> kRing = {
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

/// Costs that arrive at the nodes of a grid in the plane, of first order, for costs that depend on the direction: H(x,
/// grad u) is the density of the front. Over the eight triangles around a node (Tsitsiklis, IEEE T. Automat. Contr. 40,
/// 1995; Bornemann, Rasch 2006), in the order of the costs, and again where a node becomes cheaper, for no order is
/// right for all costs. Updates: the value at a node from one corner of a triangle, or from the edge between two.
template <class Updates>
class RingMarch {
 public:
  /// `u`: values at the seeds, which are kept, infinite elsewhere.
  RingMarch(const AllNodes& nodes, const Updates& updates, const Front& front, std::vector<double>& u)
      : nodes_(nodes), updates_(updates), front_(front), u_(u), is_seed_(u.size(), 0) {
    for (const int seed : front.seeds) {
      is_seed_[static_cast<std::size_t>(seed)] = 1;
      open_.push({u[static_cast<std::size_t>(seed)], seed});
    }
  }

  /// Throws Stopped.
  void run(const StopLook& look) {
    while (!open_.empty()) {
      look.now_and_then();
      const auto [cost, node] = open_.top();
      open_.pop();
      if (cost > u_[static_cast<std::size_t>(node)]) continue;
      const auto [i, j] = nodes_.place(node);
      for (std::size_t k = 0; k < kRing.size(); ++k) improve(i, j, k);
    }
  }

 private:
  /// The node at place k of the ring around (i, j), by what is known at (i, j).
  void improve(int i, int j, std::size_t k) {
    constexpr double kNoBetter = 1e-12;
    const int a = i + kRing[k][0], b = j + kRing[k][1];
    const int number = nodes_.find({a, b});
    if (number == nodes_.none()) return;
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
    const double u = u_[static_cast<std::size_t>(nodes_.find({i + kRing[k][0], j + kRing[k][1]}))];
    return {k, static_cast<double>(kRing[k][0]), static_cast<double>(kRing[k][1]), u};
  }

  using Open = std::pair<double, int>;
  const AllNodes& nodes_;
  const Updates& updates_;
  const Front& front_;
  std::vector<double>& u_;
  std::vector<unsigned char> is_seed_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace leastcost::bracket
