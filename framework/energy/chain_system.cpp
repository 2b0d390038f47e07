// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/chain_system.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "framework/base/symmetric_eigen.hpp"

namespace leastcost {
namespace {

constexpr Index kLook = 64;  ///< blocks between two looks at the clock

template <int K>
using Block = Eigen::Matrix<double, K, K>;

/// In-place Cholesky of a small block: lower triangle of `m`. False when a pivot is not clearly positive.
template <class Derived>
bool cholesky(Eigen::MatrixBase<Derived>& m) {
  const Index k = m.rows();
  for (Index j = 0; j < k; ++j) {
    const double original = m(j, j);
    double pivot = original;
    for (Index p = 0; p < j; ++p) pivot -= m(j, p) * m(j, p);
    // A pivot lost to cancellation is as bad as a negative one; NaN fails as well.
    if (!(pivot > 1e-15 * std::abs(original)) || !std::isfinite(pivot)) return false;
    m(j, j) = std::sqrt(pivot);
    for (Index i = j + 1; i < k; ++i) {
      double sum = m(i, j);
      for (Index p = 0; p < j; ++p) sum -= m(i, p) * m(j, p);
      m(i, j) = sum / m(j, j);
    }
  }
  return true;
}

/// m := l^-1 m for a lower triangle, column by column: Eigen's product kernels are made for larger matrices.
template <class Lower, class Matrix>
void forward(const Lower& l, Matrix& m) {
  const Index k = l.rows();
  for (Index c = 0; c < m.cols(); ++c)
    for (Index i = 0; i < k; ++i) {
      double sum = m(i, c);
      for (Index p = 0; p < i; ++p) sum -= l(i, p) * m(p, c);
      m(i, c) = sum / l(i, i);
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

template <int K>
bool ChainSystem::factor_blocks(const Deadline& deadline) {
  const Index first = ring_ ? 1 : 0;
  const int k = k_;
  Block<K> pivot(k, k), border(k, k), schur(k, k);
  if (ring_) schur = diagonal(0);
  if (ring_ && n_ == 1) schur += coupling(0) + coupling(0).transpose();  // its only segment joins x_0 with itself
  for (Index i = first; i < n_; ++i) {
    if (i % kLook == 0) look_at_clock(deadline);
    pivot = diagonal(i);
    if (i > first) {
      const Eigen::Map<const Block<K>> w(w_.data() + k * k * (i - 1), k, k);
      pivot.noalias() -= w.transpose() * w;
    }
    if (!cholesky(pivot)) return false;
    Eigen::Map<Block<K>> l(l_.data() + k * k * i, k, k);
    l = pivot;
    if (i + 1 < n_) {
      Eigen::Map<Block<K>> w(w_.data() + k * k * i, k, k);
      w = coupling(i);
      forward(l, w);
    }
    if (!ring_) continue;
    border.setZero();
    if (i == 1) border += coupling(0).transpose();
    if (i == n_ - 1) border += coupling(n_ - 1);
    if (i > 1) {
      const Eigen::Map<const Block<K>> w(w_.data() + k * k * (i - 1), k, k);
      const Eigen::Map<const Block<K>> before(border_.data() + k * k * (i - 1), k, k);
      border.noalias() -= w.transpose() * before;
    }
    forward(l, border);
    Eigen::Map<Block<K>>(border_.data() + k * k * i, k, k) = border;
    schur.noalias() -= border.transpose() * border;
  }
  if (ring_) {
    if (!cholesky(schur)) return false;
    Eigen::Map<Block<K>>(l_.data(), k, k) = schur;
  }
  return true;
}

bool ChainSystem::factor(const Deadline& deadline) {
  switch (k_) {
    case 1: return factor_blocks<1>(deadline);
    case 2: return factor_blocks<2>(deadline);
    case 3: return factor_blocks<3>(deadline);
    case 6: return factor_blocks<6>(deadline);
    case 7: return factor_blocks<7>(deadline);
    default: return factor_blocks<Eigen::Dynamic>(deadline);
  }
}

template <int K>
void ChainSystem::solve_lower_blocks(Eigen::VectorXd& x) const {
  using Vector = Eigen::Matrix<double, K, 1>;
  const Index first = ring_ ? 1 : 0;
  const int k = k_;
  const auto at = [k](const Points& m, Index i) { return Eigen::Map<const Block<K>>(m.data() + k * k * i, k, k); };
  const auto part = [k, &x](Index i) { return Eigen::Map<Vector>(x.data() + k * i, k); };
  for (Index i = first; i < n_; ++i) {
    Eigen::Map<Vector> y = part(i);
    if (i > first) y.noalias() -= at(w_, i - 1).transpose() * part(i - 1);
    at(l_, i).template triangularView<Eigen::Lower>().solveInPlace(y);
    if (ring_) part(0).noalias() -= at(border_, i).transpose() * y;
  }
  if (!ring_) return;
  Eigen::Map<Vector> y = part(0);
  at(l_, 0).template triangularView<Eigen::Lower>().solveInPlace(y);
}

template <int K>
void ChainSystem::solve_upper_blocks(Eigen::VectorXd& x) const {
  using Vector = Eigen::Matrix<double, K, 1>;
  const Index first = ring_ ? 1 : 0;
  const int k = k_;
  const auto at = [k](const Points& m, Index i) { return Eigen::Map<const Block<K>>(m.data() + k * k * i, k, k); };
  const auto part = [k, &x](Index i) { return Eigen::Map<Vector>(x.data() + k * i, k); };
  if (ring_) {
    Eigen::Map<Vector> y = part(0);
    at(l_, 0).transpose().template triangularView<Eigen::Upper>().solveInPlace(y);
  }
  for (Index i = n_ - 1; i >= first; --i) {
    Eigen::Map<Vector> y = part(i);
    if (i + 1 < n_) y.noalias() -= at(w_, i) * part(i + 1);
    if (ring_) y.noalias() -= at(border_, i) * part(0);
    at(l_, i).transpose().template triangularView<Eigen::Upper>().solveInPlace(y);
  }
}

void ChainSystem::solve_lower(Eigen::VectorXd& x) const {
  switch (k_) {
    case 1: return solve_lower_blocks<1>(x);
    case 2: return solve_lower_blocks<2>(x);
    case 3: return solve_lower_blocks<3>(x);
    case 6: return solve_lower_blocks<6>(x);
    case 7: return solve_lower_blocks<7>(x);
    default: return solve_lower_blocks<Eigen::Dynamic>(x);
  }
}

void ChainSystem::solve_upper(Eigen::VectorXd& x) const {
  switch (k_) {
    case 1: return solve_upper_blocks<1>(x);
    case 2: return solve_upper_blocks<2>(x);
    case 3: return solve_upper_blocks<3>(x);
    case 6: return solve_upper_blocks<6>(x);
    case 7: return solve_upper_blocks<7>(x);
    default: return solve_upper_blocks<Eigen::Dynamic>(x);
  }
}

void ChainSystem::solve(Eigen::VectorXd& x) const {
  solve_lower(x);
  solve_upper(x);
}

template <int K>
void ChainSystem::multiply_blocks(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  using Vector = Eigen::Matrix<double, K, 1>;
  const int k = k_;
  const auto at = [k](const Points& m, Index i) { return Eigen::Map<const Block<K>>(m.data() + k * k * i, k, k); };
  y.setZero(size());
  for (Index i = 0; i < n_; ++i) {
    const Eigen::Map<const Vector> here(x.data() + k * i, k);
    Eigen::Map<Vector> out(y.data() + k * i, k);
    out.noalias() += at(a_, i) * here;
    const Index j = i + 1 < n_ ? i + 1 : 0;
    if (j == 0 && !ring_) continue;
    out.noalias() += at(b_, i) * Eigen::Map<const Vector>(x.data() + k * j, k);
    Eigen::Map<Vector>(y.data() + k * j, k).noalias() += at(b_, i).transpose() * here;
  }
}

void ChainSystem::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  switch (k_) {
    case 1: return multiply_blocks<1>(x, y);
    case 2: return multiply_blocks<2>(x, y);
    case 3: return multiply_blocks<3>(x, y);
    case 6: return multiply_blocks<6>(x, y);
    case 7: return multiply_blocks<7>(x, y);
    default: return multiply_blocks<Eigen::Dynamic>(x, y);
  }
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
