// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

namespace leastcost {

/// Arithmetic of the small square blocks of a chain, stored by columns, as plain loops. Eigen's products are made for
/// larger matrices, and those of six sizes took four times as long to compile. K: the rows of a block where the
/// compiler is to know them (it then unrolls the loops), 0 where they are known at run time alone.
template <int K>
struct BlockKernels {
  int rows;  ///< of a block

  /// out := m
  void copy(const double* m, double* out) const {
    for (int e = 0; e < size() * size(); ++e) out[e] = m[e];
  }

  /// out += m
  void add(const double* m, double* out) const {
    for (int e = 0; e < size() * size(); ++e) out[e] += m[e];
  }

  /// out += m'
  void add_transposed(const double* m, double* out) const {
    const int k = size();
    for (int c = 0; c < k; ++c)
      for (int r = 0; r < k; ++r) out[r + k * c] += m[c + k * r];
  }

  /// out -= a' b
  void subtract_inner(const double* a, const double* b, double* out) const {
    const int k = size();
    for (int c = 0; c < k; ++c)
      for (int r = 0; r < k; ++r) out[r + k * c] -= inner(a + k * r, b + k * c);
  }

  /// The lower triangle of out -= a' a, which is all that cholesky() reads.
  void subtract_square(const double* a, double* out) const {
    const int k = size();
    for (int c = 0; c < k; ++c)
      for (int r = c; r < k; ++r) out[r + k * c] -= inner(a + k * r, a + k * c);
  }

  /// y += factor m x
  void add_product(double factor, const double* m, const double* x, double* y) const {
    if constexpr (K > 0) {  // summed apart from y, which would be stored after each column: it may overlap with m
      std::array<double, K> sum = {};
#pragma GCC unroll 8
      for (int c = 0; c < K; ++c)
#pragma GCC unroll 8
        for (int r = 0; r < K; ++r) sum[r] += x[c] * m[r + K * c];
      for (int r = 0; r < K; ++r) y[r] += factor * sum[r];
    } else {
      for (int c = 0; c < rows; ++c)
        for (int r = 0; r < rows; ++r) y[r] += factor * x[c] * m[r + rows * c];
    }
  }

  /// y += factor m' x
  void add_transposed_product(double factor, const double* m, const double* x, double* y) const {
    const int k = size();
    for (int r = 0; r < k; ++r) y[r] += factor * inner(m + k * r, x);
  }

  /// In-place Cholesky in the lower triangle. False when a pivot is not clearly positive.
  bool cholesky(double* m) const {
    const int k = size();
#pragma GCC unroll 8
    for (int j = 0; j < k; ++j) {
      const double original = m[j + k * j];
      double pivot = original;
#pragma GCC unroll 8
      for (int p = 0; p < j; ++p) pivot -= m[j + k * p] * m[j + k * p];
      // A pivot lost to cancellation is as bad as a negative one; NaN fails as well.
      if (!(pivot > 1e-15 * std::abs(original)) || !std::isfinite(pivot)) return false;
      m[j + k * j] = std::sqrt(pivot);
#pragma GCC unroll 8
      for (int i = j + 1; i < k; ++i) {
        double sum = m[i + k * j];
#pragma GCC unroll 8
        for (int p = 0; p < j; ++p) sum -= m[i + k * p] * m[j + k * p];
        m[i + k * j] = sum / m[j + k * j];
      }
    }
    return true;
  }

  /// x := l^-1 x
  void solve_lower(const double* l, double* x) const {
    const int k = size();
#pragma GCC unroll 8
    for (int i = 0; i < k; ++i) {
      double sum = x[i];
#pragma GCC unroll 8
      for (int p = 0; p < i; ++p) sum -= l[i + k * p] * x[p];
      x[i] = sum / l[i + k * i];
    }
  }

  /// m := l^-1 m, for a block
  void solve_lower_block(const double* l, double* m) const {
    for (int c = 0; c < size(); ++c) solve_lower(l, m + size() * c);
  }

  /// x := l^-T x
  void solve_upper(const double* l, double* x) const {
    const int k = size();
#pragma GCC unroll 8
    for (int i = k - 1; i >= 0; --i) {
      double sum = x[i];
#pragma GCC unroll 8
      for (int p = i + 1; p < k; ++p) sum -= l[p + k * i] * x[p];
      x[i] = sum / l[i + k * i];
    }
  }

 private:
  constexpr int size() const { return K > 0 ? K : rows; }

  double inner(const double* a, const double* b) const {
    const int k = size();
    double sum = 0;
#pragma GCC unroll 8
    for (int p = 0; p < k; ++p) sum += a[p] * b[p];
    return sum;
  }
};

}  // namespace leastcost
