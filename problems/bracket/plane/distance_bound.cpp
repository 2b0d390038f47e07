// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/distance_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/bracket/plane/dual_marching.hpp"

namespace leastcost::bracket {
namespace {

constexpr int kCorrections = 3;
constexpr int kDeflations = 4, kSampledDeflations = 8;    ///< kinks of a cost ask for more of them
constexpr double kLeastFactor = 0.6, kMostFactor = 1.15;  ///< of a correction
constexpr double kKink = 0.2;  ///< of n: a slope that falls by more within two cells is a shock's
constexpr double kOvershoot = 1.1;

/// The cost of a straight move from the end by Simpson's rule, less what a curve saves.
double straight_cost(const CostDensity& density, const EndRegion& region, const Eigen::Vector2d& d,
                     const Eigen::Vector2d& middle, const Eigen::Vector2d& end) {
  const double n0 = density.density(region.place), r = d.norm();
  const double across = r > 0 ? (region.gx * d[1] - region.gy * d[0]) / r : 0;
  return r * (n0 + 4 * density.density(middle) + density.density(end)) / 6 - r * r * r * across * across / (24 * n0);
}

/// The same where the cost depends on the direction: of a move with a bend in its middle, which is moved aside to where
/// it costs least; a parabola saves 4 / 3 of what such a move saves. `element`: F(x, v).
template <class Element>
double straight_cost(const Element& element, const EndRegion& region, const Eigen::Vector2d& d, const CellGrid& grid) {
  if (d[0] == 0 && d[1] == 0) return 0;
  constexpr double kAside = 0.05, kParabola = 4.0 / 3;
  const double sign = region.reversed ? -1 : 1;
  const auto move = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = sign * (b - a);
    const auto at = [&](double t) { return element(grid.in_box(a + t * (b - a)), along); };
    return (at(0) + 4 * at(0.5) + at(1)) / 6;
  };
  const Eigen::Vector2d end = region.place + d, aside(-kAside * d[1], kAside * d[0]);
  const auto over = [&](double s) {
    const Eigen::Vector2d middle = region.place + 0.5 * d + s * aside;
    return move(region.place, middle) + move(middle, end);
  };
  const double straight = over(0), left = over(1), right = over(-1);
  const double bend = left + right - 2 * straight, saved = (left - right) * (left - right) / (8 * bend);
  return bend > 0 && saved < 0.5 * straight ? straight - kParabola * saved : straight;
}

double straight_cost(const Medium& medium, const EndRegion& region, const Eigen::Vector2d& x, const CellGrid& grid) {
  using Eigen::Vector2d;
  const Vector2d d = x - region.place;
  if (medium.density != nullptr)
    return straight_cost(*medium.density, region, d, grid.in_box(region.place + d / 2), grid.in_box(x));
  const auto by_dual = [&](const Vector2d& at, const Vector2d& v) { return medium.dual->dual(at).cost(v[0], v[1]); };
  const auto by_values = [&](const Vector2d& at, const Vector2d& v) {
    return CoordinateCost::Element(*medium.sampled, at)(v);
  };
  return medium.dual != nullptr ? straight_cost(by_dual, region, d, grid) : straight_cost(by_values, region, d, grid);
}

bool is_above(const Net& net, double cap) {
  constexpr double kRounding = 1e-14;
  for (const auto& row : net)
    for (const double value : row)
      if (!(value * (1 - kRounding) >= cap)) return false;
  return true;
}

double largest_of(const std::vector<double>& u) {
  double largest = 0;
  for (const double value : u)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

Front front_around(const Medium& medium, const Level& level, const EndRegion& region) {
  const CellGrid& grid = level.grid;
  Front front;
  front.density = level.density;
  front.values.assign(level.density.size(), kInfinity);
  front.reversed = region.reversed;
  const double reach = (region.k + 2) * grid.h * std::sqrt(2.0);
  const int span = 2 * region.k + 6;
  for (int j = std::max(0, region.cj - span); j <= std::min(grid.ny + 1, region.cj + span); ++j)
    for (int i = std::max(0, region.ci - span); i <= std::min(grid.nx + 1, region.ci + span); ++i) {
      const Eigen::Vector2d x = grid.node(i, j), d = x - region.place;
      if (d.norm() > reach) continue;
      const double cost = straight_cost(medium, region, x, grid);
      if (!std::isfinite(cost)) continue;
      front.values[static_cast<std::size_t>(grid.id(i, j))] = cost;
      front.seeds.push_back(grid.id(i, j));
    }
  return front;
}

/// Whether two fronts meet about a node: there the mean of their slopes says nothing of n.
bool is_at_shock(const Level& level, const std::vector<double>& u, std::size_t node) {
  const auto falls = [&](std::size_t step) {
    return std::abs(u[node + step]) + std::abs(u[node - step]) - 2 * std::abs(u[node]) <
           -kKink * level.grid.h * level.density[node];
  };
  return falls(1) || falls(static_cast<std::size_t>(level.grid.stride()));
}

std::vector<double> march(const Level& level, Front& front, int corrections, FastMarching& marching) {
  const CellGrid& grid = level.grid;
  const int stride = grid.stride();
  std::vector<double> u;
  for (int pass = 0;; ++pass) {
    u = front.values;
    if (!level.is_isotropic())
      march_dual(level, front, u, marching.look());
    else if (front.order.empty())
      marching.run(grid, front.density, front.seeds, u, front.order);
    else
      marching.follow(grid, front.density, front.order, u);
    if (!front.sign.empty())
      for (std::size_t node = 0; node < u.size(); ++node) u[node] *= front.sign[node];
    if (pass == corrections) return u;
    for (int j = 1; j <= grid.ny; ++j)
      for (int i = 1; i <= grid.nx; ++i) {
        const auto node = static_cast<std::size_t>(grid.id(i, j));
        if (!(level.density[node] < kInfinity) || is_at_shock(level, u, node)) continue;
        const double gx = u[node + 1] - u[node - 1],
                     gy = u[node + static_cast<std::size_t>(stride)] - u[node - static_cast<std::size_t>(stride)];
        const double factor = 2 * grid.h * level.density[node] / level.size(node, gx, gy, front.reversed);
        if (factor > kLeastFactor && factor < kMostFactor) front.density[node] *= factor;
      }
  }
}

double check(const Level& level, const std::vector<double>& u, const EndRegion& s, const EndRegion& t,
             std::vector<double>& ratios, bool reversed, double cap) {
  const CellGrid& grid = level.grid;
  const double largest = largest_of(u);
  ratios.assign(u.size(), 0);
  double worst = 1;
  const BlockedParts nowhere;
  for (std::size_t k = 0; k < level.cells.size(); ++k) {
    const int node = level.cells[k], i = grid.column(node), j = grid.row(node);
    if ((s.valid && s.holds(i, j)) || (t.valid && t.holds(i, j))) continue;
    const auto at = static_cast<std::size_t>(node);
    if (cap < kInfinity && is_above(value_net(u, grid.stride(), at), cap)) continue;
    const BlockedParts& blocked = level.blocked.empty() ? nowhere : level.blocked[k];
    const double sign = reversed ? -1 : 1;
    const double ratio =
        !level.norms.empty() ? level.sampled_cells.ratio(grid, u, at, k, sign, blocked)
        : level.duals.empty()
            ? proved_ratio(u, grid.stride(), at, grid.h, largest, level.floors[k], {}, blocked)
            : proved_dual_ratio(u, grid.stride(), at, grid.h, largest, sign, level.dual_cells[k], {}, blocked);
    ratios[at] = ratio;
    worst = std::max(worst, ratio);
  }
  return worst;
}

namespace {

/// Lets values fade out over so many nodes around, along both axes: what is there, or more.
void fade_out(const CellGrid& grid, int nodes, std::vector<double>& values) {
  for (const bool along_x : {true, false}) {
    const std::vector<double> before = values;
    for (int j = 0; j <= grid.ny + 1; ++j)
      for (int i = 0; i <= grid.nx + 1; ++i) {
        const double here = before[static_cast<std::size_t>(grid.id(i, j))];
        if (!(here > 0)) continue;
        for (int d = -nodes; d <= nodes; ++d) {
          const int a = along_x ? i + d : i, b = along_x ? j : j + d;
          if (a < 0 || b < 0 || a > grid.nx + 1 || b > grid.ny + 1) continue;
          double& value = values[static_cast<std::size_t>(grid.id(a, b))];
          value = std::max(value, here * (1 - static_cast<double>(std::abs(d)) / (nodes + 1)));
        }
      }
  }
}

}  // namespace

void deflate(const Level& level, const std::vector<double>& ratios, Front& front) {
  // Where a cost has kinks, potentials have edges along ways: a density that jumps beside them makes new ones.
  constexpr int kFading = 3;
  const CellGrid& grid = level.grid;
  std::vector<double> excess(ratios.size(), 0);
  for (int j = 0; j <= grid.ny + 1; ++j)  // the cells of the rim depend on the nodes around the grid
    for (int i = 0; i <= grid.nx + 1; ++i) {
      double worst = 1;
      for (int b = std::max(0, j - 1); b <= std::min(grid.ny + 1, j + 1); ++b)
        for (int a = std::max(0, i - 1); a <= std::min(grid.nx + 1, i + 1); ++a)
          worst = std::max(worst, ratios[static_cast<std::size_t>(grid.id(a, b))]);
      if (worst > 1 && std::isfinite(worst)) excess[static_cast<std::size_t>(grid.id(i, j))] = kOvershoot * (worst - 1);
    }
  if (!level.norms.empty()) fade_out(grid, kFading, excess);
  for (std::size_t node = 0; node < excess.size(); ++node) {
    if (!(excess[node] > 0)) continue;
    front.density[node] /= 1 + excess[node];
    if (!front.sign.empty() || !level.norms.empty()) front.values[node] /= 1 + excess[node];
  }
}

DistanceField distance_field(const Medium& medium, const Level& level, const EndRegion& region,
                             FastMarching& marching) {
  DistanceField field{region, {}, front_around(medium, level, region)};
  field.u = march(level, field.front, kCorrections, marching);
  return field;
}

DistanceBound distance_bound(const Level& level, DistanceField field, double cap, FastMarching& marching) {
  DistanceBound bound{field.region, {}, cap, kInfinity, 0};
  std::vector<double> ratios;
  const int most = level.norms.empty() ? kDeflations : kSampledDeflations;
  for (int round = 0;; ++round) {
    const double ratio = check(level, field.u, field.region, EndRegion(), ratios, field.region.reversed, cap);
    if (round == 0 || ratio < bound.ratio) {
      bound.ratio = ratio;
      bound.u = field.u;
    }
    if (round == most || !(ratio > 1)) break;
    deflate(level, ratios, field.front);
    field.u = march(level, field.front, 0, marching);
  }
  bound.offset = rim_minimum(level.grid, bound.region, level.searched, bound.u, -1, bound.ratio);
  return bound;
}

}  // namespace leastcost::bracket
