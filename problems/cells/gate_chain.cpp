// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/gate_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Numbers = std::vector<double>;

/// Value, gradient and tridiagonal Hessian of the cost by the places on the gates.
struct Model {
  double value = 0;
  Numbers gradient, diagonal, beside;  ///< beside[i] couples i and i + 1

  explicit Model(std::size_t n) : gradient(n), diagonal(n), beside(n) {}

  /// Of legs sqrt(l^2 + rounded^2).
  void add_legs(const GateChain& chain, const Numbers& s, double rounded) {
    const std::size_t n = chain.gates.size();
    for (std::size_t i = 0; i <= n; ++i) {
      const Vector2d d = chain.place(s, i + 1) - chain.place(s, i);
      const double r = std::sqrt(d.squaredNorm() + rounded * rounded), unit = chain.units[i];
      value += unit * r;
      if (r == 0) continue;
      const int before = i > 0 ? chain.gates[i - 1].axis : 0, after = i < n ? chain.gates[i].axis : 0;
      const auto bend = [&](int a, int b) { return unit * ((a == b ? 1 : 0) - d[a] / r * d[b] / r) / r; };
      if (i > 0) gradient[i - 1] -= unit * d[before] / r, diagonal[i - 1] += bend(before, before);
      if (i < n) gradient[i] += unit * d[after] / r, diagonal[i] += bend(after, after);
      if (i > 0 && i < n) beside[i - 1] -= bend(before, after);
    }
  }
  void add_barrier(const GateChain& chain, const Numbers& s, double weight) {
    for (std::size_t i = 0; i < s.size(); ++i) {
      const double low = s[i] - chain.gates[i].low, high = chain.gates[i].high - s[i];
      value -= weight * (std::log(low) + std::log(high));
      gradient[i] -= weight * (1 / low - 1 / high);
      diagonal[i] += weight * (1 / (low * low) + 1 / (high * high));
    }
  }
  /// Places that stay are decoupled.
  void hold(const std::vector<bool>& held) {
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (!held[i]) continue;
      gradient[i] = 0, diagonal[i] = 1, beside[i] = 0;
      if (i > 0) beside[i - 1] = 0;
    }
  }
  /// The Newton step: elimination from the first to the last, and back.
  Numbers step() const {
    const std::size_t n = gradient.size();
    Numbers pivot = diagonal, x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = -gradient[i];
    for (std::size_t i = 1; i < n; ++i) {
      const double part = beside[i - 1] / pivot[i - 1];
      pivot[i] = std::max(pivot[i] - part * beside[i - 1], 1e-14 * diagonal[i]);
      x[i] -= part * x[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) x[i] = (x[i] - (i + 1 < n ? beside[i] * x[i + 1] : 0)) / pivot[i];
    return x;
  }
  double slope(const Numbers& step) const {
    double sum = 0;
    for (std::size_t i = 0; i < step.size(); ++i) sum += gradient[i] * step[i];
    return sum;
  }
};

Numbers moved(const Numbers& s, const Numbers& step, double share) {
  Numbers out = s;
  for (std::size_t i = 0; i < s.size(); ++i) out[i] += share * step[i];
  return out;
}

/// How far along a step no place leaves its gate.
double share_inside(const GateChain& chain, const Numbers& s, const Numbers& step) {
  double share = 1e9;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (step[i] > 0) share = std::min(share, (chain.gates[i].high - s[i]) / step[i]);
    if (step[i] < 0) share = std::min(share, (chain.gates[i].low - s[i]) / step[i]);
  }
  return share;
}

bool strictly_inside(const GateChain& chain, const Numbers& s) {
  for (std::size_t i = 0; i < s.size(); ++i)
    if (!(s[i] > chain.gates[i].low && s[i] < chain.gates[i].high)) return false;
  return true;
}

/// Newton under one barrier.
void centre(const GateChain& chain, double barrier, double rounded, double cost, Numbers& s) {
  constexpr int kSteps = 30;
  constexpr double kEnough = 1e-15, kBoundary = 0.98, kArmijo = 1e-4;
  for (int k = 0; k < kSteps; ++k) {
    Model model(s.size());
    model.add_legs(chain, s, rounded);
    model.add_barrier(chain, s, barrier);
    const Numbers step = model.step();
    const double slope = model.slope(step);
    if (!(slope < 0)) return;
    double share = std::min(1.0, kBoundary * share_inside(chain, s, step));
    bool found = false;
    for (int halving = 0; halving < 40 && !found; ++halving, share /= 2) {
      const Numbers trial = moved(s, step, share);
      if (!strictly_inside(chain, trial)) continue;
      Model there(s.size());
      there.add_legs(chain, trial, rounded);
      there.add_barrier(chain, trial, barrier);
      found = there.value <= model.value + kArmijo * share * slope + kEnough * cost;
      if (found) s = trial;
    }
    if (!found || -slope <= std::max(kEnough * cost, 1e-3 * barrier)) return;
  }
}

}  // namespace

double GateChain::cost(const Numbers& s) const {
  double sum = 0;
  for (std::size_t i = 0; i <= gates.size(); ++i) sum += units[i] * (place(s, i + 1) - place(s, i)).norm();
  return sum;
}

std::vector<double> least_places(const GateChain& chain, Numbers s) {
  if (s.empty()) return s;
  constexpr double kFromEnd = 0.02, kFall = 0.1, kLast = 1e-13;
  double side = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Gate& gate = chain.gates[i];
    const double length = gate.high - gate.low;
    side = std::min(side, length);
    s[i] = std::clamp(s[i], gate.low + kFromEnd * length, gate.high - kFromEnd * length);
  }
  const double cost = chain.cost(s), share = cost / static_cast<double>(s.size());
  for (double size = 1e-2; size >= kLast; size *= kFall)
    centre(chain, size * share, std::sqrt(size) * 1e-2 * side, cost, s);
  return s;
}

void polish(const GateChain& chain, Numbers& s) {
  constexpr int kSteps = 20;
  constexpr double kRounding = 1e-14;
  Numbers best = s;
  const double before = chain.cost(s);
  double least = before;
  std::vector<bool> held(s.size());
  for (int k = 0; k < kSteps; ++k) {
    Model model(s.size());
    model.add_legs(chain, s, 0);
    model.hold(held);
    const Numbers step = model.step();
    const double inside = share_inside(chain, s, step), share = std::min(1.0, inside);
    if (!std::isfinite(share)) break;
    s = moved(s, step, share);
    bool stopped = false;
    for (std::size_t i = 0; i < s.size(); ++i) {
      const Gate& gate = chain.gates[i];
      if (share == inside && step[i] != 0 && (s[i] <= gate.low || s[i] >= gate.high)) held[i] = stopped = true;
      s[i] = std::clamp(s[i], gate.low, gate.high);
    }
    const double cost = chain.cost(s);
    if (!(cost <= least + kRounding * before)) break;
    best = s;
    least = std::min(least, cost);
    if (!stopped && -model.slope(step) <= 1e-3 * kRounding * kRounding * before) break;
  }
  s = best;
}

double excess_above_least(const GateChain& chain, const Numbers& s) {
  double excess = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vector2d before = chain.place(s, i + 1) - chain.place(s, i),
                   after = chain.place(s, i + 2) - chain.place(s, i + 1);
    const Gate& gate = chain.gates[i];
    const auto along = [&](const Vector2d& d) { return d.norm() > 0 ? d[gate.axis] / d.norm() : 0; };
    const double slope = chain.units[i] * along(before) - chain.units[i + 1] * along(after);
    excess += std::max(slope * (s[i] - gate.low), -slope * (gate.high - s[i]));
  }
  return excess;
}

}  // namespace leastcost
