// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstddef>

#include "framework/base/symmetric_eigen.hpp"
#include "framework/proof/tube_field.hpp"

namespace leastcost {

/// The coefficients of the Riccati equation at one place of the curve.
template <int N, int D>
class RiccatiPoint {
 public:
  static constexpr int kAcross = N - 1;
  using Small = Eigen::Matrix<double, kAcross, kAcross>;
  using Square = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  RiccatiPoint(const TubeField<N, D>& field, const TubeSegment<N, D>& segment, double t) {
    const TubeSegment<N, D> here = segment.around(t);
    const Interval zero(0);
    const typename TubeField<N, D>::OnCurve curve = field.on_curve(here, zero);
    std::array<IntervalJet<N>, kAcross> z;
    for (int k = 0; k < kAcross; ++k) z[static_cast<std::size_t>(k)] = IntervalJet<N>::variable(zero, k + 1);
    const JetMatrix<N> g = field.metric_in_tube(here, zero, z);
    Square g0;
    std::array<Square, kAcross> g1;
    std::array<std::array<Square, kAcross>, kAcross> g2;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) {
        const IntervalJet<N>& entry = g[N * i + j];
        const auto r = static_cast<Index>(i), c = static_cast<Index>(j);
        g0(r, c) = entry.value().middle();
        for (int k = 0; k < kAcross; ++k) {
          g1[static_cast<std::size_t>(k)](r, c) = entry.d(k + 1).middle();
          for (int l = 0; l < kAcross; ++l)
            g2[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)](r, c) = entry.d(k + 1, l + 1).middle();
        }
      }
    h_ = g0.inverse();
    y_[0] = curve.speed.value().middle();
    for (int k = 0; k < kAcross; ++k) {
      const auto n = static_cast<std::size_t>(k);
      y_[k + 1] = curve.across[n].value().middle();
      across_rate_[k] = curve.across_rate[n].value().middle();
    }
    for (std::size_t k = 0; k < kAcross; ++k) hy_[k] = -h_ * g1[k] * h_ * y_;
    for (int k = 0; k < kAcross; ++k)
      for (int l = 0; l < kAcross; ++l) {
        const auto a = static_cast<std::size_t>(k), b = static_cast<std::size_t>(l);
        const Square hkl = h_ * (g1[a] * h_ * g1[b] + g1[b] * h_ * g1[a] - g2[a][b]) * h_;
        free_(k, l) = y_.dot(hkl * y_);
      }
    // Where the curvature is negative extremals part by themselves, and the margin can be as large as half of it.
    own_margin_ = std::max(0.0, -symmetric_eigenvalues(free_).maxCoeff() / 4);
  }

  /// W' such that the Hessian of f across the curve is -2m, m at least `margin`.
  Small rate(const Small& w, double margin, double own_part) const {
    Eigen::Matrix<double, N, kAcross> yz;
    yz.row(0) = across_rate_.transpose();
    yz.bottomRows(kAcross) = w;
    Small rest = free_ + 2 * yz.transpose() * h_ * yz;
    for (int l = 0; l < kAcross; ++l) {
      const Eigen::Matrix<double, kAcross, 1> column = 2 * yz.transpose() * hy_[static_cast<std::size_t>(l)];
      rest.col(l) += column;
      rest.row(l) += column.transpose();
    }
    rest.diagonal().array() += 2 * (margin + own_part * own_margin_);
    return -rest / (2 * h_.row(0).dot(y_));
  }

  double momentum_across() const { return y_.template tail<kAcross>().norm(); }

  using Cube = std::array<Small, kAcross>;

  /// The rate of the third derivatives of u for which those of f vanish; `rest` are those of f without them.
  Cube third_rate(const Small& w, const Cube& c, const Cube& rest) const {
    Eigen::Matrix<double, N, kAcross> yz;
    yz.row(0) = across_rate_.transpose();
    yz.bottomRows(kAcross) = w;
    Eigen::Matrix<double, kAcross, kAcross> momentum_slope;  // d(Hy)_j / dz_k
    for (int k = 0; k < kAcross; ++k) {
      const Vector slope = hy_[static_cast<std::size_t>(k)] + h_ * yz.col(k);
      momentum_slope.col(k) = slope.template tail<kAcross>();
    }
    Cube out;
    const double along = 2 * h_.row(0).dot(y_);
    for (int k = 0; k < kAcross; ++k)
      for (int l = 0; l < kAcross; ++l)
        for (int m = 0; m < kAcross; ++m) {
          double sum = rest[static_cast<std::size_t>(k)](l, m);
          for (int j = 0; j < kAcross; ++j) {
            const Small& cj = c[static_cast<std::size_t>(j)];
            sum += 2 * (momentum_slope(j, k) * cj(l, m) + momentum_slope(j, l) * cj(k, m) +
                        momentum_slope(j, m) * cj(k, l));
          }
          out[static_cast<std::size_t>(k)](l, m) = -sum / along;
        }
    return out;
  }

 private:
  Square h_;
  Vector y_;
  Eigen::Matrix<double, kAcross, 1> across_rate_;
  std::array<Vector, kAcross> hy_;  ///< (dH / dz_k) y
  Small free_;                      ///< y' d2H y
  double own_margin_ = 0;
};

}  // namespace leastcost
