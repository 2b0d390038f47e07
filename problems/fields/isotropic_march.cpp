// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/isotropic_march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/fields/node_moves.hpp"
#include "problems/graph/monotone_queue.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kUnreached = std::numeric_limits<double>::infinity();

}  // namespace

IsotropicMarch::IsotropicMarch(const Lattice& lattice, const std::vector<double>& densities, Passes passes)
    : lattice_(lattice), passes_(std::move(passes)), width_(lattice.count[0] + 2) {
  for (std::size_t k = 0; k < kRing.size(); ++k) {
    ring_[k] = kRing[k][0] + width_ * kRing[k][1];
    moves_[k] = lattice.step.cwiseProduct(Vector2d(kRing[k][0], kRing[k][1]));
    lengths_[k] = moves_[k].norm();
  }
  const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(lattice.count[1] + 2);
  nodes_.assign(size, {kUnreached, 0, 0, std::numeric_limits<float>::infinity(), 1});
  std::size_t next = 0;
  for (std::int32_t j = 0; j < lattice.count[1]; ++j)
    for (std::int32_t i = 0; i < lattice.count[0]; ++i) {
      const double n = densities[next++];
      if (!(n >= 0) || !(n < kUnreached)) continue;
      Node& node = nodes_[static_cast<std::size_t>(number(i, j))];
      node.density = static_cast<float>(n);
      node.final = 0;
    }
}

Vector2d IsotropicMarch::place(std::int32_t node) const { return lattice_.place(node % width_ - 1, node / width_ - 1); }

void IsotropicMarch::start(const Vector2d& source,
                           const std::function<double(const Vector2d&, const Vector2d&)>& cost) {
  constexpr double kReach = 3.5;  // steps: nearer by the cubic would be less exact than the straight move
  const Vector2d at = (source - lattice_.lower).cwiseQuotient(lattice_.step);
  const auto low = [&](int axis) { return static_cast<std::int32_t>(std::max(std::ceil(at[axis] - kReach), 0.0)); };
  const auto high = [&](int axis) {
    return static_cast<std::int32_t>(
        std::min(std::floor(at[axis] + kReach), lattice_.count[static_cast<std::size_t>(axis)] - 1.0));
  };
  for (std::int32_t j = low(1); j <= high(1); ++j)
    for (std::int32_t i = low(0); i <= high(0); ++i) {
      const std::int32_t number_here = number(i, j);
      Node& node = nodes_[static_cast<std::size_t>(number_here)];
      const Vector2d here = lattice_.place(i, j), move = here - source;
      if (move.cwiseQuotient(lattice_.step).norm() > kReach || !(node.density < kUnreached)) continue;
      const double c = cost(source, here);
      if (!(c < node.u) || (passes_ && !passes_(source, here))) continue;
      node.u = c;
      node.px = static_cast<float>(move[0]), node.py = static_cast<float>(move[1]);
      started_.push_back(number_here);
    }
}

/// n is bilinear in the cell: its integral along a move is (n(node) + n(a)) / 2 + dn s, with the fourth corner in dn.
bool IsotropicMarch::inside_edge(const Node& node, std::size_t axis, std::int32_t near, std::int32_t far, double fourth,
                                 Offer& offer) const {
  constexpr double kSameFront = 0.5;  // the cosine between the gradients of one front
  constexpr int kSteps = 2;           // from the secant of the slopes: what is left counts by its square
  const Node &a = nodes_[static_cast<std::size_t>(near)], &b = nodes_[static_cast<std::size_t>(far)];
  // The edge is `near` + s q along the other axis, s from 0 to 1; `node` is p off `near`.
  const std::size_t k = axis;
  const bool along_x = k % 4 == 0;
  const double p = lengths_[k];
  const double q = along_x ? lattice_.step[1] : lattice_.step[0];
  const double sign = (far > near) == ((along_x ? width_ : 1) > 0) ? 1 : -1;
  const double rise = b.u - a.u;
  double slope_a = sign * q * double(along_x ? a.py : a.px), slope_b = sign * q * double(along_x ? b.py : b.px);
  if (double(a.px) * double(b.px) + double(a.py) * double(b.py) < kSameFront * double(a.density) * double(b.density))
    slope_a = slope_b = rise;
  const double n0 = 0.5 * (double(node.density) + double(a.density));
  const double dn = (double(b.density) - double(a.density)) / 3 + (fourth - double(node.density)) / 6;
  // The slopes of the sum at both ends say whether its least value is inside.
  const double diagonal = lengths_[1];
  const double first = slope_a + dn * p, last = slope_b + dn * diagonal + (n0 + dn) * q * q / diagonal;
  if (!(first < 0) || !(last > 0)) return false;
  const double curve_a = slope_a - rise, curve_b = slope_b - rise;
  double s = first / (first - last), length = p;
  for (int i = 0; i < kSteps; ++i) {
    length = std::sqrt(p * p + q * q * s * s);
    const double n = n0 + dn * s, bend = q * q / length;
    const double du = rise + (1 - s) * (1 - 3 * s) * curve_a - s * (2 - 3 * s) * curve_b;
    const double ddu = (6 * s - 4) * curve_a + (6 * s - 2) * curve_b;
    const double slope = du + dn * length + n * bend * s;
    const double curvature = ddu + 2 * dn * bend * s + n * bend * p * p / (length * length);
    if (!(curvature > 0)) break;
    s = std::clamp(s - slope / curvature, 0.0, 1.0);
  }
  length = std::sqrt(p * p + q * q * s * s);
  offer.u = a.u + s * rise + s * (1 - s) * ((1 - s) * curve_a - s * curve_b) + (n0 + dn * s) * length;
  offer.x = moves_[k][0] + (along_x ? 0 : sign * q * s);
  offer.y = moves_[k][1] + (along_x ? sign * q * s : 0);
  return true;
}

bool IsotropicMarch::take(std::int32_t number, const Offer& offer) {
  Node& node = nodes_[static_cast<std::size_t>(number)];
  if (!(offer.u < node.u)) return false;
  if (passes_) {
    const Vector2d here = place(number);
    if (!passes_(here + Vector2d(offer.x, offer.y), here)) return false;
  }
  node.u = offer.u;
  node.px = static_cast<float>(-offer.x);
  node.py = static_cast<float>(-offer.y);
  return true;
}

/// Turns the direction of the last move into the gradient. A ray bends by what n grows across it: the move is a chord,
/// whose direction is that of the ray half a length earlier.
void IsotropicMarch::finish(std::int32_t number) {
  constexpr double kSmooth = 0.3;  // of n within a move: more is a jump, at which no gradient of n bends a ray
  Node& node = nodes_[static_cast<std::size_t>(number)];
  node.final = 1;
  const double n = node.density;
  const auto growth = [&](std::int32_t to, double step) {
    const float before = nodes_[static_cast<std::size_t>(number - to)].density,
                after = nodes_[static_cast<std::size_t>(number + to)].density;
    const double rise = double(after) - double(before);
    return std::abs(rise) < kUnreached ? rise / (4 * step) : 0.0;  // not finite: no value on one side
  };
  const double x = node.px, y = node.py, length = std::sqrt(x * x + y * y);
  if (!(length > 0) || !(n > 0)) {
    node.px = node.py = 0;
    return;
  }
  // The bend, times the length and n.
  const double bx = length * growth(1, lattice_.step[0]), by = length * growth(width_, lattice_.step[1]);
  double gx = x / length, gy = y / length;
  if (bx * bx + by * by < kSmooth * kSmooth * n * n) {
    const double along = (bx * gx + by * gy) / n;
    gx += bx / n - along * gx, gy += by / n - along * gy;
    const double scale = 1 / std::sqrt(gx * gx + gy * gy);
    gx *= scale, gy *= scale;
  }
  node.px = static_cast<float>(n * gx);
  node.py = static_cast<float>(n * gy);
}

void IsotropicMarch::run(const std::function<bool()>& stop) {
  constexpr int kNodesPerLook = 4096;
  MonotoneQueue<std::int32_t> queue;
  for (const std::int32_t node : started_) queue.push(nodes_[static_cast<std::size_t>(node)].u, node);
  started_.clear();
  for (int steps = 1; !queue.empty(); ++steps) {
    if (steps % kNodesPerLook == 0 && stop && stop())
      throw Interrupted("field: interrupted before all nodes were reached");
    const auto [c, by] = queue.pop();
    if (nodes_[static_cast<std::size_t>(by)].final != 0) continue;
    finish(by);
    const Node& from = nodes_[static_cast<std::size_t>(by)];
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const std::int32_t number = by + ring_[k];
      const Node& node = nodes_[static_cast<std::size_t>(number)];
      if (node.final != 0) continue;
      // A move inside a cell needs all of its corners: nothing is known where one has no cost.
      const auto density = [&](std::int32_t corner) {
        return double(nodes_[static_cast<std::size_t>(corner)].density);
      };
      const std::size_t back = (k + 4) % 8;  // of `by` in the ring of the node
      bool cheaper = false;
      for (const std::size_t turn : {std::size_t{1}, std::size_t{7}}) {
        const std::size_t beside = (back + turn) % 8;
        const std::int32_t other = number + ring_[beside];
        const Node& beyond = nodes_[static_cast<std::size_t>(other)];
        if (beyond.final == 0 || !(beyond.density < kUnreached)) continue;
        Offer offer{};
        const bool straight = back % 2 == 0;
        const double fourth = density(straight ? number + other - by : number + by - other);
        if (!(fourth < kUnreached)) continue;
        if (straight ? inside_edge(node, back, by, other, fourth, offer)
                     : inside_edge(node, beside, other, by, fourth, offer))
          cheaper = take(number, offer) || cheaper;
      }
      const bool straight = back % 2 == 0;
      const double others =
          straight ? 0 : density(number + ring_[(back + 1) % 8]) + density(number + ring_[(back + 7) % 8]);
      const bool joined = others < kUnreached;
      const double mean = straight || !joined ? 0.5 * (double(from.density) + double(node.density))
                                              : (double(from.density) + double(node.density)) / 3 + others / 6;
      const Offer direct{from.u + mean * lengths_[back], moves_[back][0], moves_[back][1]};
      if (((joined || passes_corners_) && take(number, direct)) || cheaper) queue.push(node.u, number);
    }
  }
}

std::vector<double> IsotropicMarch::values() const {
  std::vector<double> values;
  values.reserve(nodes_.size());
  for (std::int32_t j = 0; j < lattice_.count[1]; ++j)
    for (std::int32_t i = 0; i < lattice_.count[0]; ++i)
      values.push_back(nodes_[static_cast<std::size_t>(number(i, j))].u);
  return values;
}

}  // namespace leastcost
