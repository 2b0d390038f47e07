// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "framework/tube_metric.hpp"
#include "framework/tube_segment.hpp"

namespace leastcost {

/// The dual norm of the potential of framework/calibration.hpp and what it is made of, as jets in t (variable 0) and z
/// (1 .. kAcross).
template <int N>
class TubeField {
 public:
  static constexpr int kAcross = N - 1;
  using Jet = IntervalJet<N>;
  using Small = Eigen::Matrix<double, kAcross, kAcross>;

  explicit TubeField(const TubeMetric<N>& metric) : metric_(metric) {}

  /// What is known of the curve alone for t in a range: its speed, and the part of its momentum across it.
  struct OnCurve {
    Jet speed;
    std::array<Jet, kAcross> across, across_rate;
  };

  OnCurve on_curve(const TubeSegment<N>& segment, const Interval& range) const {
    JetPoint<N> x, dx;
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = jet(segment.curve[i], range);
      dx[i] = jet(segment.curve[i].derivative(), range);
    }
    const JetMatrix<N> g = metric_(x);
    JetPoint<N> momentum;
    Jet speed2(0.0);
    for (std::size_t i = 0; i < N; ++i) {
      momentum[i] = Jet(0.0);
      for (std::size_t j = 0; j < N; ++j) momentum[i] += g[N * i + j] * dx[j];
      speed2 += momentum[i] * dx[i];
    }
    OnCurve out;
    out.speed = sqrt(speed2);
    for (std::size_t k = 0; k < kAcross; ++k) {
      Jet sum(0.0);
      for (std::size_t i = 0; i < N; ++i) sum += jet(segment.frame[i][k], range) * momentum[i];
      out.across[k] = sum / out.speed;
      out.across_rate[k] = out.across[k].derivative(0);
    }
    return out;
  }

  /// f = |grad u|^2 in the dual norm, and what of its Hessian across the curve does not depend on W and its rate.
  Jet squared_norm(const TubeSegment<N>& segment, const OnCurve& curve, const Interval& range,
                   const std::array<Interval, kAcross>& across) const {
    std::array<Jet, kAcross> z;
    for (std::size_t k = 0; k < kAcross; ++k) z[k] = IntervalJet<N>::variable(across[k], static_cast<int>(k) + 1);
    return norm_of(gradient(segment, curve, range, z), metric_in_tube(segment, range, z)).tighten();
  }

  /// The metric in the coordinates (t, z).
  JetMatrix<N> metric_in_tube(const TubeSegment<N>& segment, const Interval& t,
                              const std::array<Jet, kAcross>& z) const {
    JetPoint<N> x;
    JetMatrix<N> d;  // dx / d(t, z), column by column
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = jet(segment.curve[i], t);
      d[i] = jet(segment.curve[i].derivative(), t);
      for (std::size_t k = 0; k < kAcross; ++k) {
        const Jet n = jet(segment.frame[i][k], t);
        x[i] += n * z[k];
        d[i] += jet(segment.frame[i][k].derivative(), t) * z[k];
        d[N * (k + 1) + i] = n;
      }
    }
    const JetMatrix<N> g = metric_(x);
    JetMatrix<N> out;
    for (std::size_t p = 0; p < N; ++p) {
      JetPoint<N> gd;
      for (std::size_t i = 0; i < N; ++i) {
        gd[i] = Jet(0.0);
        for (std::size_t j = 0; j < N; ++j) gd[i] += g[N * i + j] * d[N * p + j];
      }
      for (std::size_t q = p; q < N; ++q) {
        Jet sum(0.0);
        for (std::size_t i = 0; i < N; ++i) sum += d[N * q + i] * gd[i];
        out[N * p + q] = out[N * q + p] = sum;
      }
    }
    return out;
  }

  /// du / d(t, z).
  JetPoint<N> gradient(const TubeSegment<N>& segment, const OnCurve& curve, const Interval& t,
                       const std::array<Jet, kAcross>& z) const {
    JetPoint<N> y;
    y[0] = curve.speed;
    for (std::size_t k = 0; k < kAcross; ++k) {
      y[0] += curve.across_rate[k] * z[k];
      y[k + 1] = curve.across[k];
      for (std::size_t l = 0; l < kAcross; ++l) {
        y[k + 1] += jet(segment.w[k][l], t) * z[l];
        const Jet zz = z[k] * z[l];
        y[0] += (jet(segment.w[k][l].derivative(), t) * zz).scaled(0.5);
        for (std::size_t m = 0; m < kAcross; ++m) {
          y[m + 1] += (jet(segment.third[m][k][l], t) * zz).scaled(0.5);
          y[0] += (jet(segment.third[m][k][l].derivative(), t) * zz * z[m]).scaled(Interval(1) / Interval(6));
        }
      }
    }
    return y;
  }

  /// y' g^-1 y, by elimination.
  static Jet norm_of(JetPoint<N> y, JetMatrix<N> g) {
    Jet sum(0.0);
    for (std::size_t i = N; i-- > 0;) {                           // the direction along the curve last
      if (!(g[N * i + i].value().lo > 0)) return Jet::unknown();  // no metric
      const Jet inverse = Jet(1.0) / g[N * i + i];
      sum += y[i] * y[i] * inverse;
      for (std::size_t j = 0; j < i; ++j) {
        const Jet factor = g[N * i + j] * inverse;
        y[j] -= factor * y[i];
        for (std::size_t k = 0; k < i; ++k) g[N * j + k] -= factor * g[N * i + k];
      }
    }
    return sum;
  }

 private:
  static Jet jet(const Cubic& c, const Interval& t) { return c.template jet<N>(t); }

  const TubeMetric<N>& metric_;
};

}  // namespace leastcost
