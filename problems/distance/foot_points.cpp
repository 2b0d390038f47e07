// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/foot_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "problems/distance/distance_signs.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

struct Open {
  std::array<int, 3> node;
  std::int32_t hint;
};

/// The corners of the cell around x.
template <class Visit>
void for_corners(const GridShape& shape, const Vector3d& x, Visit visit) {
  const Vector3d t = ((x - shape.origin) / shape.cell).array().floor();
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> node{};
    bool within = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double at = t[axis] + ((corner >> axis) & 1);
      const auto a = static_cast<std::size_t>(axis);
      within = within && at >= 0 && at < shape.count[a];
      node[a] = within ? static_cast<int>(at) : 0;
    }
    if (within) visit(node);
  }
}

/// One pass in memory order (forward) or against it: feet come from the 13 neighbours that the pass has been to.
void pass(FootPointGrid& field, bool forward, const BuildProgress& progress, double done, double share) {
  const auto& n = field.shape.count;
  const int sign = forward ? -1 : 1;
  const auto row = [&](int i, int j, int k) {
    const std::size_t here = field.shape.index(i, j, k);
    if (field.exact[here] != 0) return;
    const Vector3d x = field.shape.cell * Vector3d(i, j, k);
    double best = field.distance[here] * field.distance[here];
    std::size_t from = here;
    const auto offer = [&](int di, int dj, int dk) {
      const int a = i + di, b = j + dj, c = k + dk;
      if (a < 0 || a >= n[0] || b < 0 || b >= n[1] || c < 0 || c >= n[2]) return;
      const std::size_t other = field.shape.index(a, b, c);
      if (!field.known(other)) return;
      const double squared = (field.feet[other].cast<double>() - x).squaredNorm();
      if (squared < best) best = squared, from = other;
    };
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) offer(di, dj, sign);
    for (int di = -1; di <= 1; ++di) offer(di, sign, 0);
    offer(sign, 0, 0);
    if (from == here) return;
    field.feet[here] = field.feet[from];
    field.distance[here] = std::sqrt(best);
  };
  for (int c = 0; c < n[2]; ++c) {
    report(progress, done + share * c / n[2], "distances far from the surface");
    for (int b = 0; b < n[1]; ++b)
      for (int a = 0; a < n[0]; ++a)
        row(forward ? a : n[0] - 1 - a, forward ? b : n[1] - 1 - b, forward ? c : n[2] - 1 - c);
  }
}

}  // namespace

FootPointGrid::FootPointGrid(const GridShape& grid)
    : shape(grid),
      distance(grid.nodes(), std::numeric_limits<double>::infinity()),
      feet(grid.nodes(), Eigen::Vector3f::Zero()),
      side(grid.nodes(), 0),
      exact(grid.nodes(), 0) {}

void FootPointGrid::set(std::size_t node, const Vector3d& where, double how_far) {
  feet[node] = (where - shape.origin).cast<float>();
  distance[node] = how_far;
}

void fill_band(FootPointGrid& field, const std::vector<Vector3d>& seeds, double band,
               const std::function<std::optional<Foot>(const Vector3d& x, std::int32_t hint)>& nearest,
               const BuildProgress& progress) {
  const GridShape& shape = field.shape;
  std::vector<Open> open;
  std::vector<char> seen(shape.nodes(), 0);
  for (const Vector3d& seed : seeds) {
    for_corners(shape, seed, [&](const std::array<int, 3>& node) {
      char& mark = seen[shape.index(node[0], node[1], node[2])];
      if (std::exchange(mark, 1) == 0) open.push_back({node, -1});
    });
  }
  constexpr std::size_t kReport = 4096;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (i % kReport == 0)
      report(progress, static_cast<double>(i) / static_cast<double>(open.size()), "distances near the surface");
    const auto [node, hint] = open[i];
    const std::size_t here = shape.index(node[0], node[1], node[2]);
    const Vector3d x = shape.node(node[0], node[1], node[2]);
    const std::optional<Foot> foot = nearest(x, hint);
    if (!foot) continue;
    const double distance = (x - foot->position).norm();
    field.set(here, foot->position, distance);
    field.exact[here] = 1;
    field.side[here] = foot->side;
    if (distance > band) continue;
    for_neighbours(shape, node, [&](std::size_t next, const std::array<int, 3>& at) {
      if (std::exchange(seen[next], 1) == 0) open.push_back({at, foot->hint});
    });
  }
}

void spread_feet(FootPointGrid& field, const BuildProgress& progress) {
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    pass(field, true, progress, 0.5 * round, 0.25);
    pass(field, false, progress, 0.5 * round + 0.25, 0.25);
  }
}

}  // namespace leastcost
