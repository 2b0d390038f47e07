// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The second order of an arrival field: sweeps with the gradients at the nodes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/fields/arrival_field.hpp"

namespace leastcost {

using Eigen::Vector2d;

/// The gradient of u where the last move comes by v is that of the line element F(v): with F of degree one along the
/// edge of the ring that v comes from, v(t), it has
///
///     gradient . v = F(v),   gradient . dv/dt = dF(v(t))/dt.
Vector2d ArrivalField::gradient_by(std::int32_t node, const Vector2d& v) const {
  constexpr double kOnEdge = 1 - 1e-9;
  const NodeMoves& moves = *node_moves_;
  const std::size_t parts = moves.parts(), all = moves.directions();
  Vector2d from = -v.cwiseQuotient(step_);
  from /= from.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < kRing.size(); ++k) {
    const Vector2d first(kRing[k][0], kRing[k][1]);
    const auto& next = kRing[(k + 1) % kRing.size()];
    const Vector2d along = Vector2d(next[0], next[1]) - first, across = first - first.dot(along) * along;
    const double t = (from - first).dot(along);
    if (!(t >= 0) || !(t <= 1) || !(from.dot(across) >= kOnEdge)) continue;
    const auto middle =
        static_cast<std::size_t>(std::clamp(std::round(t * double(parts)), 1.0, std::max(1.0, double(parts) - 1)));
    const auto squared = [&](std::size_t part) {
      const double c = moves.cost(node, (parts * k + part + (how_.reversed ? all / 2 : 0)) % all);
      return c * c;
    };
    const double a = squared(middle - 1), b = squared(middle), c = squared(middle + 1);
    const double s = (t * double(parts) - double(middle - 1)) / 2;
    const double p1 = 4 * b - 3 * a - c, p2 = 2 * (a + c) - 4 * b;
    const double cost = std::sqrt(a + s * (p1 + s * p2)), growth = (p1 + 2 * p2 * s) / (2 * cost) * double(parts) / 2;
    Eigen::Matrix2d rows;
    rows << (-step_.cwiseProduct(first + t * along)).transpose(), (-step_.cwiseProduct(along)).transpose();
    return rows.inverse() * Vector2d(cost, growth);
  }
  return Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

/// What u bends along the edge between node `by`, number k of a ring, and the next of the ring; 0 where its gradients
/// belong to two fronts.
double ArrivalField::bend_along(const std::vector<Eigen::Vector2f>& gradients, std::int32_t by, std::int32_t other,
                                std::size_t k) const {
  const auto& next = kRing[(k + 1) % kRing.size()];
  const std::array<std::int32_t, 2> along = {next[0] - kRing[k][0], next[1] - kRing[k][1]};
  const Vector2d edge = step_.cwiseProduct(Vector2d(along[0], along[1]));
  const auto of = [&](std::int32_t node) { return gradients[static_cast<std::size_t>(node)].cast<double>(); };
  const double bend = (of(by) - of(other)).dot(edge);
  const auto direction = static_cast<std::size_t>(std::find(kRing.begin(), kRing.end(), along) - kRing.begin());
  const std::size_t parts = node_moves_->parts(), all = node_moves_->directions();
  const double there_and_back =
      node_moves_->cost(by, parts * direction) + node_moves_->cost(by, (parts * direction + all / 2) % all);
  return std::abs(bend) < there_and_back / 2 ? bend : 0;
}

bool ArrivalField::sharpen_node(std::int32_t node, std::vector<Eigen::Vector2f>& gradients) {
  const std::array<std::int32_t, 3> at = lattice_.place(node);
  const auto neighbour = [&](std::size_t k) {
    const std::int32_t i = at[0] + kRing[k % kRing.size()][0], j = at[1] + kRing[k % kRing.size()][1];
    const bool inside = i >= 0 && j >= 0 && i < lattice_.count[0] && j < lattice_.count[1];
    const std::int32_t number = inside ? lattice_.number({i, j, 0}) : -1;
    return inside && known(number) && !node_moves_->blocked(number) ? number : -1;
  };
  Arrival best;
  for (std::size_t k = 0; k < kRing.size(); ++k) {
    const std::int32_t by = neighbour(k), other = neighbour(k + 1);
    if (by < 0) continue;
    const double bend = other < 0 ? 0 : bend_along(gradients, by, other, k);
    if (!try_triangle(node, by, other < 0 ? by : other, k, 1, best, std::isfinite(bend) ? bend : 0)) return false;
  }
  if (!(best.cost < kNever)) return false;
  Arrival& arrival = arrivals_[static_cast<std::size_t>(node)];
  constexpr double kSettled = 1e-6;  // of the cost
  const bool changed = std::abs(best.cost - arrival.cost) > kSettled * arrival.cost;
  arrival = best;
  gradients[static_cast<std::size_t>(node)] =
      gradient_by(node, coordinates({node, node, 0}) - coordinates(best.from)).cast<float>();
  return changed;
}

/// Over an edge from a to b with the gradients p and q at its ends, u is (1 - t) u(a) + t u(b) + t (1 - t) (p - q).(b -
/// a) / 2, exactly if it is quadratic. The field of first order gives the gradients and the order of the nodes; sweeps
/// in that order, because a node may depend on one that comes later.
void ArrivalField::sharpen(const std::function<bool()>& stop) {
  constexpr int kMostSweeps = 100, kNodesPerLook = 1024;
  constexpr unsigned char kMostTurns = 20;  // of a node: beside a cliff values go up and down without end
  std::vector<Eigen::Vector2f> gradients(arrivals_.size(), Eigen::Vector2f::Zero());
  std::vector<unsigned char> fixed(arrivals_.size(), 0);
  for (const auto& [node, move] : starts_) {
    const auto n = static_cast<std::size_t>(node);
    if (arrivals_[n].from.a >= 0) continue;
    fixed[n] = 1;
    if (move.norm() > 0) gradients[n] = gradient_by(node, move).cast<float>();
  }
  std::vector<std::int32_t> order;
  order.reserve(arrivals_.size());
  for (std::int32_t node = 0; node < static_cast<std::int32_t>(arrivals_.size()); ++node) {
    const auto n = static_cast<std::size_t>(node);
    if (!known(node) || fixed[n] != 0) continue;
    gradients[n] = gradient_by(node, coordinates({node, node, 0}) - coordinates(arrivals_[n].from)).cast<float>();
    if (doubtful_[n] == 0) order.push_back(node);
  }
  std::sort(order.begin(), order.end(), [this](std::int32_t a, std::int32_t b) { return value(a) < value(b); });
  std::vector<unsigned char> waiting(arrivals_.size(), 1);  // nodes beside one that has changed
  std::vector<unsigned char> turns(arrivals_.size(), 0);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool changed = false;
    int steps = 0;
    for (const std::int32_t node : order) {
      if (++steps % kNodesPerLook == 0 && stop())
        throw Interrupted("field: interrupted while the arrival costs were computed");
      if (waiting[static_cast<std::size_t>(node)] == 0) continue;
      waiting[static_cast<std::size_t>(node)] = 0;
      if (++turns[static_cast<std::size_t>(node)] > kMostTurns) continue;
      if (!sharpen_node(node, gradients)) continue;
      changed = true;
      const std::array<std::int32_t, 3> at = lattice_.place(node);
      for (const auto& [i, j] : kRing)
        if (at[0] + i >= 0 && at[1] + j >= 0 && at[0] + i < lattice_.count[0] && at[1] + j < lattice_.count[1])
          waiting[static_cast<std::size_t>(lattice_.number({at[0] + i, at[1] + j, 0}))] = 1;
    }
    if (!changed) break;
  }
}

}  // namespace leastcost
