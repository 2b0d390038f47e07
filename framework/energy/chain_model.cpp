// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/chain_model.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace leastcost {
namespace {

/// A semidefinite Gauss-Newton Hessian (a ring that may drift, points that may slide) is lifted by a growing part of
/// its own size.
void factor_lifted(PathEnergy& energy, ChainSystem& system) {
  double size = 0;
  for (Index i = 0; i < system.count(); ++i) size += system.diagonal(i).trace();
  size /= static_cast<double>(system.size());
  const double unit = size > 0 && std::isfinite(size) ? size : 1;
  double lifted = 0;
  for (double part = 1e-10; !energy.factor(system); part *= 100) {
    const double lift = part * unit - lifted;
    for (Index i = 0; i < system.count(); ++i) system.diagonal(i).diagonal().array() += lift;
    lifted += lift;
    if (part > 1e10) {  // not finite: fall back to steepest descent
      system.set_zero();
      for (Index i = 0; i < system.count(); ++i) system.diagonal(i).diagonal().setConstant(unit);
    }
  }
}

/// Largest change of a segment by a step, relative to that segment; lengths in coordinates.
double spacing_change(const CoordinatePath& path, const Points& step) {
  const Index n = step.cols();
  double worst = 0;
  for (Index s = 0; s < path.segment_count(); ++s) {
    const Index a = s - path.free_begin(), b = path.ring && a + 1 == n ? 0 : a + 1;
    const bool closes = path.ring && b == 0 && !path.closing.identity();
    const double length2 = closes ? (path.column(s + 1) - path.u.col(s)).squaredNorm()
                                  : (path.u.col(path.ring && b == 0 ? 0 : s + 1) - path.u.col(s)).squaredNorm();
    double change2 = 0;
    for (Index row = 0; row < step.rows(); ++row) {
      const double sign = closes ? path.closing.sign[row] : 1;
      const double d = (b < n ? sign * step(row, b) : 0) - (a >= 0 ? step(row, a) : 0);
      change2 += d * d;
    }
    if (length2 > 0) worst = std::max(worst, change2 / length2);
  }
  return std::sqrt(worst);
}

}  // namespace

void lift_drift(ChainSystem& system) {
  double size = 0;
  for (Index i = 0; i < system.count(); ++i) size += system.diagonal(i).trace();
  const double n = static_cast<double>(system.count());
  const double lift = size / static_cast<double>(system.size()) * (1 - std::cos(2 * std::numbers::pi / n));
  if (!std::isfinite(lift)) return;
  for (Index i = 0; i < system.count(); ++i) system.diagonal(i).diagonal().array() += lift;
}

bool ChainModel::evaluate(PathEnergy& energy, const CoordinatePath& path) {
  value = energy.value_and_gradient(path, gradient);
  if (!std::isfinite(value)) return false;
  energy.frames(path, gradient, frames);
  if (const auto* pieces = find_ability<HasPieces>(*energy.problem().manifold)) {
    moves = gradient;
    pieces->into_pieces(path, moves);
    energy.to_tangent(frames, moves, tangent);
  } else {
    energy.to_tangent(frames, gradient, tangent);
  }
  return true;
}

void ChainModel::solve(PathEnergy& energy, const CoordinatePath& path, HessianKind wanted) {
  exact = false;
  if (wanted == HessianKind::exact && energy.has_exact_hessian()) {
    energy.chain_hessian(path, gradient, frames, HessianKind::exact, system);
    exact = energy.factor(system);
  }
  if (!exact) {
    energy.chain_hessian(path, gradient, frames, HessianKind::gauss_newton, system);
    if (path.ring) lift_drift(system);
    factor_lifted(energy, system);
  }
  step = -tangent;
  energy.solve(system, step);
  decrement = -tangent.dot(step);
  const double scale = energy.scale(path);
  cost_error = scale > 0 ? decrement / (2 * scale) : std::numeric_limits<double>::infinity();
  energy.from_tangent(frames, step, moves);
  spacing_error = spacing_change(path, moves);
}

double rounding_slack(double value, Index segments) {
  return 4 * std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(segments)) * std::abs(value);
}

}  // namespace leastcost
