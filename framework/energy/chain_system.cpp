// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/chain_system.hpp>

#include <cmath>

#include "framework/base/symmetric_eigen.hpp"
#include "framework/energy/block_kernels.hpp"

namespace leastcost {
namespace {

constexpr Index kLook = 64;  ///< blocks between two looks at the clock

/// Calls `visit` with the kernels for blocks of k rows. The sizes of planes, surfaces, space, bodies and arms are known
/// to the compiler.
template <class Visit>
auto with_kernels(int k, const Visit& visit) {
  switch (k) {
    case 1: return visit(BlockKernels<1>{1});
    case 2: return visit(BlockKernels<2>{2});
    case 3: return visit(BlockKernels<3>{3});
    case 6: return visit(BlockKernels<6>{6});
    case 7: return visit(BlockKernels<7>{7});
    default: return visit(BlockKernels<0>{k});
  }
}

}  // namespace

void ChainSystem::resize(int block, Index count, bool ring) {
  k_ = block;
  n_ = count;
  ring_ = ring;
  for (Points* m : {&a_, &b_, &l_, &w_}) m->resize(k_, k_ * n_);
  border_.resize(k_, ring ? k_ * n_ : 0);
}

void ChainSystem::set_zero() {
  a_.setZero();
  b_.setZero();
}

void ChainSystem::add(double factor, const ChainSystem& other) {
  a_ += factor * other.a_;
  b_ += factor * other.b_;
}

template <class Kernels>
bool ChainSystem::factor_blocks(const Kernels& of, const Deadline& deadline) {
  const Index first = ring_ ? 1 : 0;
  const auto at = [this](Points& side_by_side, Index i) { return side_by_side.data() + k_ * k_ * i; };
  double* const schur = l_.data();  // ring: that of x_0 gathers where its factor will be
  if (ring_) of.copy(at(a_, 0), schur);
  if (ring_ && n_ == 1) {  // its only segment joins x_0 with itself
    of.add(at(b_, 0), schur);
    of.add_transposed(at(b_, 0), schur);
  }
  for (Index i = first; i < n_; ++i) {
    if (i % kLook == 0) look_at_clock(deadline);
    double* const l = at(l_, i);
    of.copy(at(a_, i), l);
    if (i > first) of.subtract_square(at(w_, i - 1), l);
    if (!of.cholesky(l)) return false;
    if (i + 1 < n_) {
      of.copy(at(b_, i), at(w_, i));
      of.solve_lower_block(l, at(w_, i));
    }
    if (!ring_) continue;
    double* const border = at(border_, i);
    border_.middleCols(k_ * i, k_).setZero();
    if (i == 1) of.add_transposed(at(b_, 0), border);
    if (i == n_ - 1) of.add(at(b_, n_ - 1), border);
    if (i > 1) of.subtract_inner(at(w_, i - 1), at(border_, i - 1), border);
    of.solve_lower_block(l, border);
    of.subtract_square(border, schur);
  }
  return !ring_ || of.cholesky(schur);
}

bool ChainSystem::factor(const Deadline& deadline) {
  return with_kernels(k_, [&](const auto& of) { return factor_blocks(of, deadline); });
}

template <class Kernels>
void ChainSystem::solve_lower_blocks(const Kernels& of, double* x) const {
  const Index first = ring_ ? 1 : 0;
  const auto at = [this](const Points& side_by_side, Index i) { return side_by_side.data() + k_ * k_ * i; };
  for (Index i = first; i < n_; ++i) {
    double* const y = x + k_ * i;
    if (i > first) of.add_transposed_product(-1, at(w_, i - 1), y - k_, y);
    of.solve_lower(at(l_, i), y);
    if (ring_) of.add_transposed_product(-1, at(border_, i), y, x);
  }
  if (ring_) of.solve_lower(at(l_, 0), x);
}

template <class Kernels>
void ChainSystem::solve_upper_blocks(const Kernels& of, double* x) const {
  const Index first = ring_ ? 1 : 0;
  const auto at = [this](const Points& side_by_side, Index i) { return side_by_side.data() + k_ * k_ * i; };
  if (ring_) of.solve_upper(at(l_, 0), x);
  for (Index i = n_ - 1; i >= first; --i) {
    double* const y = x + k_ * i;
    if (i + 1 < n_) of.add_product(-1, at(w_, i), y + k_, y);
    if (ring_) of.add_product(-1, at(border_, i), x, y);
    of.solve_upper(at(l_, i), y);
  }
}

void ChainSystem::solve_lower(Eigen::VectorXd& x) const {
  with_kernels(k_, [&](const auto& of) { solve_lower_blocks(of, x.data()); });
}

void ChainSystem::solve_upper(Eigen::VectorXd& x) const {
  with_kernels(k_, [&](const auto& of) { solve_upper_blocks(of, x.data()); });
}

void ChainSystem::solve(Eigen::VectorXd& x) const {
  solve_lower(x);
  solve_upper(x);
}

template <class Kernels>
void ChainSystem::multiply_blocks(const Kernels& of, const double* x, double* y) const {
  const auto at = [this](const Points& side_by_side, Index i) { return side_by_side.data() + k_ * k_ * i; };
  for (Index i = 0; i < n_; ++i) {
    of.add_product(1, at(a_, i), x + k_ * i, y + k_ * i);
    const Index j = i + 1 < n_ ? i + 1 : 0;
    if (j == 0 && !ring_) continue;
    of.add_product(1, at(b_, i), x + k_ * j, y + k_ * i);
    of.add_transposed_product(1, at(b_, i), x + k_ * i, y + k_ * j);
  }
}

void ChainSystem::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.setZero(size());
  with_kernels(k_, [&](const auto& of) { multiply_blocks(of, x.data(), y.data()); });
}

ChainSystem::Elimination ChainSystem::eliminate(const Deadline& deadline) const {
  Elimination e;
  for (auto* blocks : {&e.root, &e.border}) blocks->resize(static_cast<std::size_t>(n_));
  e.signs.resize(static_cast<std::size_t>(n_));
  // Counts the negative eigenvalues of a pivot; one that is lost to rounding counts as positive.
  const auto split = [&e](const Points& pivot, Index i) {
    const SymmetricEigen eigen = symmetric_eigen(pivot);
    const double tiny = 1e-300 + 1e-15 * eigen.values.cwiseAbs().maxCoeff();
    if (eigen.values[0] < 0 && e.first_negative < 0) {
      e.first_negative = i;
      e.negative = eigen.vectors.col(0);
    }
    e.negatives += static_cast<int>((eigen.values.array() < 0).count());
    const auto at = static_cast<std::size_t>(i);
    e.signs[at] = (eigen.values.array() < 0).select(-1.0, Eigen::VectorXd::Ones(eigen.values.size()));
    const Eigen::VectorXd scale = eigen.values.cwiseAbs().cwiseMax(tiny).cwiseSqrt().cwiseInverse();
    e.root[at] = scale.asDiagonal() * eigen.vectors.transpose();
  };
  const Index first = ring_ ? 1 : 0;
  Points schur;
  if (ring_) schur = diagonal(0);
  if (ring_ && n_ == 1) schur += coupling(0) + coupling(0).transpose();
  for (Index i = first; i < n_; ++i) {
    if (i % kLook == 0) look_at_clock(deadline);
    const auto at = static_cast<std::size_t>(i);
    Points pivot = diagonal(i);
    Points border = Points::Zero(k_, k_);
    if (i > first) {
      const Points w = e.root[at - 1] * coupling(i - 1);
      const Points eliminated = w.transpose() * e.signs[at - 1].asDiagonal();
      pivot -= eliminated * w;
      if (ring_) border -= eliminated * (e.root[at - 1] * e.border[at - 1]);
    }
    split(pivot, i);
    if (!ring_) continue;
    if (i == 1) border += coupling(0).transpose();
    if (i == n_ - 1) border += coupling(n_ - 1);
    const Points w = e.root[at] * border;
    schur -= w.transpose() * e.signs[at].asDiagonal() * w;
    e.border[at] = std::move(border);
  }
  if (ring_) split(schur, 0);
  return e;
}

int ChainSystem::negative_eigenvalues(const Deadline& deadline) const { return eliminate(deadline).negatives; }

Eigen::VectorXd ChainSystem::negative_direction(const Deadline& deadline) const {
  const Elimination e = eliminate(deadline);
  if (e.first_negative < 0) return {};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size());
  x.segment(k_ * e.first_negative, k_) = e.negative;
  const bool at_pin = ring_ && e.first_negative == 0;
  for (Index i = at_pin ? n_ - 1 : e.first_negative - 1; i >= (ring_ ? 1 : 0); --i) {
    const auto at = static_cast<std::size_t>(i);
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(k_);
    if (i + 1 < n_) pull += coupling(i) * x.segment(k_ * (i + 1), k_);
    if (at_pin) pull += e.border[at] * e.negative;
    x.segment(k_ * i, k_) = -(e.root[at].transpose() * e.signs[at].asDiagonal() * (e.root[at] * pull));
  }
  return x;
}

}  // namespace leastcost
