// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/derived_cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace leastcost {
namespace {

/// phi(q) = q.
struct SquareItself {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;
  Jet2 operator()(double q) const { return {q, 1, 0}; }
};

/// phi of each segment, q in units of s0^2.
std::vector<Jet2> kernel_jets(const Kernel& kernel, const Eigen::VectorXd& q, double s0) {
  const Eigen::VectorXd scaled = q / (s0 * s0);
  std::vector<Jet2> jets(static_cast<std::size_t>(q.size()));
  kernel.apply({scaled.data(), jets.size()}, jets);
  return jets;
}

}  // namespace

SquaredCosts squared_costs_of(const SegmentCost& cost, const AmbientPath& path, bool with_hessians) {
  SquaredCosts out;
  const Index n = path.segment_count(), width = 2 * cost.dim();
  out.q.resize(n);
  cost.squared_costs(path, {out.q.data(), static_cast<std::size_t>(n)});
  cost.residuals(path, out.residuals, &out.jacobians);
  out.gradients.resize(width, n);
  for (Index i = 0; i < n; ++i) out.gradients.col(i) = 2 * out.jacobian(i).transpose() * out.residuals.col(i);
  if (!with_hessians) return out;
  ChainBlocks blocks;
  cost.chain_blocks(path, KernelOf<SquareItself>(), 1, HessianKind::exact, blocks);
  out.hessians = std::move(blocks.blocks);
  return out;
}

double DerivedCost::energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                                        Eigen::Ref<Points> gradient) const {
  const SquaredCosts c = derive(path, false);
  const std::vector<Jet2> phi = kernel_jets(kernel, c.q, s0);
  gradient.setZero();
  double energy = 0;
  for (Index i = 0; i < c.count(); ++i) {
    const Jet2& jet = phi[static_cast<std::size_t>(i)];
    energy += jet.value;
    const double slope = jet.d1 / (s0 * s0);
    gradient.col(i) += slope * c.gradients.col(i).head(dim_);
    gradient.col(i + 1) += slope * c.gradients.col(i).tail(dim_);
  }
  return std::isnan(energy) ? std::numeric_limits<double>::infinity() : energy;
}

void DerivedCost::chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                               ChainBlocks& out) const {
  constexpr double kLeastStiffness = 1e-3;  // of phi'' along the path, as for other costs with a residual
  const bool exact = kind == HessianKind::exact;
  const SquaredCosts c = derive(path, exact);
  const std::vector<Jet2> phi = kernel_jets(kernel, c.q, s0);
  const double scale = 1 / (s0 * s0);
  const Index width = 2 * dim_;
  out.blocks.resize(width, width * c.count());
  for (Index i = 0; i < c.count(); ++i) {
    Jet2 jet = phi[static_cast<std::size_t>(i)];
    auto block = out.blocks.middleCols(width * i, width);
    const double q = scale * c.q[i];
    if (exact) {
      block = jet.d1 * scale * c.hessian(i);
    } else {
      if (q > 0) jet.d2 = std::max(jet.d2, -(1 - kLeastStiffness) * jet.d1 / (2 * q));
      block.noalias() = (2 * jet.d1 * scale) * c.jacobian(i).transpose() * c.jacobian(i);
    }
    block.noalias() += (jet.d2 * scale * scale) * c.gradients.col(i) * c.gradients.col(i).transpose();
  }
}

void DerivedCost::residuals(const AmbientPath& path, Points& r, Points* jacobians) const {
  SquaredCosts c = derive(path, false);
  r = std::move(c.residuals);
  if (jacobians != nullptr) *jacobians = std::move(c.jacobians);
}

}  // namespace leastcost
