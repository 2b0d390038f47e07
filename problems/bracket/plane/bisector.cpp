// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/bisector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost::bracket {
namespace {

/// Half the difference of the two fields around a node, by central differences.
struct LocalField {
  double f, fx, fy, fxx, fxy, fyy;

  LocalField(const std::vector<double>& values, std::size_t node, std::size_t stride, double h) {
    const auto at = [&](int p, int q) {
      return values[static_cast<std::size_t>(static_cast<long>(node) + q * static_cast<long>(stride) + p)];
    };
    f = at(0, 0);
    fx = (at(1, 0) - at(-1, 0)) / (2 * h);
    fy = (at(0, 1) - at(0, -1)) / (2 * h);
    fxx = (at(1, 0) - 2 * f + at(-1, 0)) / (h * h);
    fyy = (at(0, 1) - 2 * f + at(0, -1)) / (h * h);
    fxy = (at(1, 1) - at(-1, 1) - at(1, -1) + at(-1, -1)) / (4 * h * h);
  }
};

/// The signed cost from a node to the bisector: the distance by one step of Halley along the gradient, times the
/// density in its middle.
double cost_to_bisector(const LocalField& field, const std::vector<double>& density, std::size_t node,
                        std::size_t stride, double h) {
  const double slope = std::hypot(field.fx, field.fy) + 1e-12, nx = field.fx / slope, ny = field.fy / slope;
  const double bend = nx * nx * field.fxx + 2 * nx * ny * field.fxy + ny * ny * field.fyy;
  const double first = field.f / slope, distance = first + 0.5 * bend / slope * first * first, n = density[node];
  if (!(std::abs(distance) < 1.5 * h) || distance * field.f < 0)
    return std::copysign(std::min(1.42 * h, std::abs(field.f) / n), field.f) * n;
  const double rise = (density[node + 1] - density[node - 1]) / (2 * h) * nx +
                      (density[node + stride] - density[node - stride]) / (2 * h) * ny;
  return distance * (n - (std::isfinite(rise) ? 0.5 * rise * distance : 0));
}

/// The same where the cost depends on the direction: u = a f (1 - f (dH/dp . grad a) / 2), a = 1 / H(x, grad f), has
/// H(x, grad u) = 1 up to the square of f.
double dual_cost_to_bisector(const std::vector<double>& half, const Level& level, int i, int j) {
  const CellGrid& grid = level.grid;
  const auto node = static_cast<std::size_t>(grid.id(i, j)), stride = static_cast<std::size_t>(grid.stride());
  const auto slope = [&](std::size_t at) -> Eigen::Vector2d {
    return Eigen::Vector2d(half[at + 1] - half[at - 1], half[at + stride] - half[at - stride]) / (2 * grid.h);
  };
  const auto factor = [&](std::size_t at) {
    const Eigen::Vector2d p = slope(at);
    return 1 / level.size(at, p[0], p[1], false);
  };
  const double f = half[node], a = factor(node);
  if (i < 2 || j < 2 || i >= grid.nx || j >= grid.ny) return a * f;
  const Eigen::Vector2d p = slope(node);
  const Eigen::Vector2d v = level.steepest(node, p);
  const double rise =
      (v[0] * (factor(node + 1) - factor(node - 1)) + v[1] * (factor(node + stride) - factor(node - stride))) /
      (2 * grid.h);
  constexpr double kMost = 0.5;  // beyond is a shock
  return std::abs(f * rise) < kMost ? a * f * (1 - 0.5 * f * rise) : a * f;
}

}  // namespace

Front front_at_bisector(const Level& level, const std::vector<double>& from_s, const std::vector<double>& from_t) {
  const CellGrid& grid = level.grid;
  const auto stride = static_cast<std::size_t>(grid.stride());
  Front front;
  front.density = level.density;
  front.values.assign(from_s.size(), kInfinity);
  front.sign.assign(from_s.size(), 1);
  std::vector<double> half(from_s.size());
  for (std::size_t node = 0; node < half.size(); ++node) {
    half[node] = 0.5 * (from_s[node] - from_t[node]);  // NaN where neither goes
    if (half[node] < 0) front.sign[node] = -1;
  }
  for (int j = 1; j <= grid.ny; ++j)
    for (int i = 1; i <= grid.nx; ++i) {
      const auto node = static_cast<std::size_t>(grid.id(i, j));
      if (!std::isfinite(half[node])) continue;
      bool beside = false;
      for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) {
          const auto other = static_cast<std::size_t>(grid.id(i + a, j + b));
          beside = beside || (std::isfinite(half[other]) && front.sign[other] != front.sign[node]);
        }
      if (!beside) continue;
      const double cost = level.is_isotropic()
                              ? cost_to_bisector({half, node, stride, grid.h}, level.density, node, stride, grid.h)
                              : dual_cost_to_bisector(half, level, i, j);
      if (!std::isfinite(cost)) continue;
      front.values[node] = std::abs(cost);
      front.seeds.push_back(static_cast<int>(node));
    }
  return front;
}

}  // namespace leastcost::bracket
