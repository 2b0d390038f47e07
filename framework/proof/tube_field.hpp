// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "framework/proof/tube_graph.hpp"
#include "framework/proof/tube_metric.hpp"
#include "framework/proof/tube_segment.hpp"

namespace leastcost {

/// The dual norm of the potential of framework/proof/calibration.hpp and what it is made of, as jets in t (variable 0)
/// and z (1 .. kAcross).
template <int N, int D>
class TubeField {
 public:
  static constexpr int kAcross = N - 1;
  using Jet = IntervalJet<N>;
  using Small = Eigen::Matrix<double, kAcross, kAcross>;

  /// The metric must outlive this object.
  explicit TubeField(const TubeMetric<N, D>& metric) : metric_(metric) {}

  /// What is known of the curve alone for t in a range: its speed, and the part of its momentum across it.
  struct OnCurve {
    Jet speed;
    std::array<Jet, kAcross> across, across_rate;
  };

  OnCurve on_curve(const TubeSegment<N, D>& segment, const Interval& range) const {
    const JetPoint<N> row = metric_on_curve(segment, range);
    OnCurve out;
    out.speed = sqrt(row[0]);
    for (std::size_t k = 0; k < kAcross; ++k) {
      out.across[k] = row[k + 1] / out.speed;
      out.across_rate[k] = out.across[k].derivative(0);
    }
    return out;
  }

  /// f = |grad u|^2 in the dual norm, and what of its Hessian across the curve does not depend on W and its rate.
  Jet squared_norm(const TubeSegment<N, D>& segment, const OnCurve& curve, const Interval& range,
                   const std::array<Interval, kAcross>& across) const {
    std::array<Jet, kAcross> z;
    for (std::size_t k = 0; k < kAcross; ++k) z[k] = IntervalJet<N>::variable(across[k], static_cast<int>(k) + 1);
    return norm_of(gradient(segment, curve, range, z), metric_in_tube(segment, range, z)).tighten();
  }

  /// Whether there is a metric at t on the curve because a surface lies beside it as a graph; else the fault is the
  /// cost's.
  bool lies_on_surface(const TubeSegment<N, D>& segment, double t) const {
    if constexpr (D > N)
      return TubeGraph(metric_.surface()).height(segment.around(t), Interval(0), Jet(0.0)).value().is_finite();
    return true;
  }

  /// The metric in the coordinates (t, z).
  JetMatrix<N> metric_in_tube(const TubeSegment<N, D>& segment, const Interval& t,
                              const std::array<Jet, kAcross>& z) const {
    if constexpr (D > N)
      return metric_on_surface(segment, t, z);
    else
      return metric_in_space(segment, t, z);
  }

  /// du / d(t, z).
  JetPoint<N> gradient(const TubeSegment<N, D>& segment, const OnCurve& curve, const Interval& t,
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
  /// The first row of the metric for z = 0.
  JetPoint<N> metric_on_curve(const TubeSegment<N, D>& segment, const Interval& t) const {
    JetPoint<N> row;
    if constexpr (D > N) {
      const JetMatrix<N> g = metric_on_surface(segment, t, {});
      std::copy_n(g.begin(), N, row.begin());
    } else {
      JetPoint<N> x, dx;
      for (std::size_t i = 0; i < N; ++i) {
        x[i] = jet(segment.curve[i], t);
        dx[i] = jet(segment.curve[i].derivative(), t);
      }
      const JetMatrix<N> g = metric_(x);
      row.fill(Jet(0.0));
      for (std::size_t i = 0; i < N; ++i) {
        Jet momentum(0.0);
        for (std::size_t j = 0; j < N; ++j) momentum += g[N * i + j] * dx[j];
        row[0] += momentum * dx[i];
        for (std::size_t k = 0; k < kAcross; ++k) row[k + 1] += jet(segment.frame[i][k], t) * momentum;
      }
    }
    return row;
  }

  JetMatrix<N> metric_in_space(const TubeSegment<N, D>& segment, const Interval& t,
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

  /// x = gamma + z n + h normal, whose height h is a function of t and z: F(x) = 0 gives its value and its slopes.
  JetMatrix<N> metric_on_surface(const TubeSegment<N, D>& segment, const Interval& t,
                                 const std::array<Jet, kAcross>& z) const {
    static_assert(N == 2 && D == 3);
    const Jet h = TubeGraph(metric_.surface()).height(segment, t, z[0]);
    std::array<LevelSetEnclosure::Sloped, D> at;
    JetPoint<N, D> x, normal, d[N];
    for (std::size_t i = 0; i < D; ++i) {
      normal[i] = jet(segment.normal[i][0], t);
      d[1][i] = jet(segment.frame[i][0], t);
      d[0][i] = jet(segment.curve[i].derivative(), t) + jet(segment.frame[i][0].derivative(), t) * z[0] +
                jet(segment.normal[i][0].derivative(), t) * h;
      x[i] = jet(segment.curve[i], t) + d[1][i] * z[0] + normal[i] * h;
      at[i].value = x[i];
      at[i].d[i] = Jet(1.0);
    }
    const JetPoint<N, D> gradient = metric_.surface().enclose(std::span<const LevelSetEnclosure::Sloped, D>(at)).d;
    const auto along_gradient = [&gradient](const JetPoint<N, D>& v) {
      return (gradient[0] * v[0] + gradient[1] * v[1] + gradient[2] * v[2]).tighten();
    };
    const Jet steepness = along_gradient(normal);
    std::array<Jet, N * D> jacobian;
    for (std::size_t p = 0; p < N; ++p) {
      const Jet slope = -(along_gradient(d[p]) / steepness);
      for (std::size_t i = 0; i < D; ++i) jacobian[N * i + p] = (d[p][i] + slope * normal[i]).tighten();
    }
    return metric_.pulled_back(x, jacobian);
  }

  template <std::size_t Degree>
  static Jet jet(const Polynomial<Degree>& c, const Interval& t) {
    return c.template jet<N>(t);
  }

  const TubeMetric<N, D>& metric_;
};

}  // namespace leastcost
