// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/search/sampled_medium.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "problems/bracket/cubic_minimum.hpp"
#include "problems/bracket/search/bent_move.hpp"
#include "problems/bracket/search/growth.hpp"
#include "problems/bracket/search/ring_marching.hpp"

namespace leastcost::bracket {
namespace {

/// Of a norm that is known in some directions: the move that costs least is among those, or near the best of them.
class SampledUpdates {
 public:
  SampledUpdates(const SampledNorms& norms, double h) : norms_(norms), h_(h), sector_(norms.directions() / 8) {
    for (int k = 0; k < norms.directions(); ++k) {
      const Eigen::Vector2d& e = norms.direction(k);
      const auto& [ax, ay] = kRing[static_cast<std::size_t>(k / sector_)];
      const auto& [bx, by] = kRing[static_cast<std::size_t>(k / sector_ + 1) % kRing.size()];
      const double det = ax * by - ay * bx;
      const double a = (e[0] * by - e[1] * bx) / det, b = (ax * e[1] - ay * e[0]) / det;  // e = a A + b B
      moves_.push_back({b / (a + b), 1 / (a + b)});
    }
  }

  /// Every edge is a cell away.
  double least_of_move(const At& at) const { return at.density * h_ * norms_.least_cost(at.node); }

  double over_node(const At& at, const Corner& a) const {
    const double length = std::hypot(a.x, a.y) * h_;
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
      return (1 - move.share) * first.u + move.share * last.u + at.density * move.length * h_ * towards(at, from + k);
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
  double towards(const At& at, int k) const { return norms_.cost(at.node, at.back ? k : k + norms_.directions() / 2); }

  const SampledNorms& norms_;
  const double h_;
  const int sector_;
  std::vector<Move> moves_;
};

}  // namespace

double SampledMedium::cost_near(const End& end, const Grid<2>& grid, const Eigen::Vector2d& x, double) const {
  return bent_move_cost(end, grid, x, [&](const Eigen::Vector2d& at, const Eigen::Vector2d& v) {
    return CoordinateCost::Element(cost_, at)(v);
  });
}

void SampledMedium::Known::learn_node(const SampledMedium& medium, const Part<2>& part, int node,
                                      const Eigen::Vector2d& x) {
  if (part.density[static_cast<std::size_t>(node)] < kInfinity)
    norms_.learn(static_cast<std::size_t>(node), {medium.cost_, x});
  else
    unknown_.push_back(node);
}

void SampledMedium::Known::end_of_nodes(Part<2>& part) {
  constexpr int kLayers = 12;
  std::vector<int> unknown = std::move(unknown_);
  for (int layer = 1; layer <= kLayers && !unknown.empty(); ++layer) {
    std::vector<int> rest;
    std::vector<std::pair<int, int>> filled;
    for (const int node : unknown) {
      const auto [i, j] = part.nodes.place(node);
      int from = part.nodes.none();
      for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) {
          const int other = part.nodes.find({i + a, j + b});
          if (norms_.knows(static_cast<std::size_t>(other))) from = other;
        }
      if (from == part.nodes.none())
        rest.push_back(node);
      else
        filled.emplace_back(node, from);
    }
    for (const auto& [node, from] : filled) {
      norms_.take_over(static_cast<std::size_t>(node), static_cast<std::size_t>(from));
      part.density[static_cast<std::size_t>(node)] = growth_at_depth(part.grid, layer * part.grid.h);
    }
    unknown = std::move(rest);
  }
}

void SampledMedium::Known::march(const Part<2>& part, const Front& front, std::vector<double>& u,
                                 const FastMarching& marching) const {
  const SampledUpdates updates(norms_, part.grid.h);
  RingMarch(part.nodes, updates, front, u).run(marching.look());
}

void SampledMedium::Known::spread(const Part<2>& part, std::vector<double>& excess) const {
  constexpr int kNodes = 3;  // around, along both axes
  for (const std::size_t axis : {0U, 1U}) {
    const std::vector<double> before = excess;
    for (int node = 0; node < part.nodes.none(); ++node) {
      const double here = before[static_cast<std::size_t>(node)];
      if (!(here > 0)) continue;
      for (int d = -kNodes; d <= kNodes; ++d) {
        Place<2> p = part.nodes.place(node);
        p[axis] += d;
        if (!part.nodes.holds(p)) continue;
        double& value = excess[static_cast<std::size_t>(part.nodes.find(p))];
        value = std::max(value, here * (1 - static_cast<double>(std::abs(d)) / (kNodes + 1)));
      }
    }
  }
}

}  // namespace leastcost::bracket
