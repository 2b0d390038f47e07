// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <leastcost/framework/deadline.hpp>
#include "framework/gauss.hpp"
#include "framework/tube_metric.hpp"
#include "framework/tube_segment.hpp"

namespace leastcost {

/// The tube of framework/calibration.hpp: the piecewise cubic curve with continuous tangents through the points of an
/// open chain, its frame, and its width, segment by segment.
template <int N>
class Tube {
 public:
  static constexpr int kAcross = N - 1;

  /// It reaches a part of one of `delivered` segments to each side. Throws Interrupted.
  Tube(const TubeMetric<N>& metric, const CoordinatePath& chain, Index delivered, const Deadline& deadline)
      : metric_(metric), chain_(chain) {
    exists_ = make_segments(deadline) && measure();
    if (exists_) set_widths(delivered);
  }

  /// False: too few points, or a metric that is not finite and positive definite on the curve (motion from rest, a
  /// pole).
  bool exists() const { return exists_; }

  std::vector<TubeSegment<N>> segments;
  Eigen::VectorXd costs;   ///< of the curve in each segment, by Gauss' rule
  Eigen::VectorXd widths;  ///< half the width, units of the cost
  double cost = 0;         ///< of the curve

 private:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Square = Eigen::Matrix<double, N, N>;
  using Frame = Eigen::Matrix<double, N, kAcross>;
  static constexpr double kWidth = 0.25;  ///< of a segment, to each side

  Square metric_at(const Eigen::VectorXd& x) const {
    JetPoint<N> at;
    for (std::size_t i = 0; i < N; ++i) at[i] = IntervalJet<N>(x[static_cast<Index>(i)]);
    const JetMatrix<N> g = metric_(at);
    Square out;
    for (Index i = 0; i < N; ++i)
      for (Index j = 0; j < N; ++j) out(i, j) = g[static_cast<std::size_t>(N * i + j)].value().middle();
    return out;
  }

  /// dx/di at point i, of order 4.
  Vector slope(Index i) const {
    static constexpr double kStencils[3][5] = {{-25. / 12, 4, -3, 4. / 3, -1. / 4},
                                               {-1. / 4, -5. / 6, 3. / 2, -1. / 2, 1. / 12},
                                               {1. / 12, -2. / 3, 0, 2. / 3, -1. / 12}};
    const Index last = chain_.u.cols() - 1;
    const bool mirrored = i > last / 2;
    const Index from_end = mirrored ? last - i : i;
    const Index row = std::min<Index>(from_end, 2), begin = from_end - row;
    Vector d = Vector::Zero();
    for (Index j = 0; j < 5; ++j) d += kStencils[row][j] * chain_.u.col(mirrored ? last - begin - j : begin + j);
    return mirrored ? Vector(-d) : d;
  }

  /// A frame across d that is orthonormal under g, as little turned from `before` as can be.
  static Frame frame(const Square& g, const Vector& d, const Frame& before) {
    Frame out;
    const Vector gd = g * d;
    if constexpr (N == 2) {
      out << -gd[1], gd[0];
      return out / std::sqrt(out.col(0).dot(g * out.col(0)));
    }
    for (int k = 0; k < kAcross; ++k) {
      Vector n = before.col(k);
      n -= gd.dot(n) / gd.dot(d) * d;
      for (int l = 0; l < k; ++l) n -= out.col(l).dot(g * n) * out.col(l);
      out.col(k) = n / std::sqrt(n.dot(g * n));
    }
    return out;
  }

  bool make_segments(const Deadline& deadline) {
    const Index count = chain_.segment_count();
    if (count < 4) return false;
    Frame across;
    Vector d = slope(0);
    Index longest = 0;
    d.cwiseAbs().maxCoeff(&longest);
    for (int k = 0; k < kAcross; ++k) across.col(k) = Vector::Unit((longest + 1 + k) % N);
    across = frame(metric_at(chain_.u.col(0)), d, across);
    segments.resize(static_cast<std::size_t>(count));
    for (Index i = 0; i < count; ++i) {
      look_at_clock(deadline);
      const Vector next_d = slope(i + 1);
      const Frame next = frame(metric_at(chain_.u.col(i + 1)), next_d, across);
      if (!next.allFinite() || !across.allFinite()) return false;
      TubeSegment<N>& segment = segments[static_cast<std::size_t>(i)];
      for (Index r = 0; r < N; ++r) {
        const auto n = static_cast<std::size_t>(r);
        segment.curve[n] = Cubic::hermite(chain_.u(r, i), chain_.u(r, i + 1), d[r], next_d[r]);
        for (Index k = 0; k < kAcross; ++k)
          segment.frame[n][static_cast<std::size_t>(k)] = Cubic::line(across(r, k), next(r, k));
      }
      d = next_d;
      across = next;
    }
    return true;
  }

  bool measure() {
    costs.resize(static_cast<Index>(segments.size()));
    for (Index i = 0; i < costs.size(); ++i) costs[i] = cost_of(segments[static_cast<std::size_t>(i)]);
    cost = costs.sum();
    return std::isfinite(cost);
  }

  /// Half the width of the tube at each segment, in units of the cost: a part of a segment, both in cost and in
  /// coordinates, so that no soft direction makes it reach far.
  void set_widths(Index delivered) {
    const double per_segment = static_cast<double>(segments.size()) / static_cast<double>(delivered);
    widths.resize(costs.size());
    for (Index i = 0; i < costs.size(); ++i) {
      const TubeSegment<N>& segment = segments[static_cast<std::size_t>(i)];
      double longest2 = 0;
      for (std::size_t k = 0; k < kAcross; ++k) {
        double length2 = 0;
        for (const auto& row : segment.frame) length2 += row[k].c[0] * row[k].c[0];
        longest2 = std::max(longest2, length2);
      }
      const double length = (chain_.u.col(i + 1) - chain_.u.col(i)).norm();
      widths[i] = kWidth * std::min(cost / static_cast<double>(delivered), per_segment * length / std::sqrt(longest2));
    }
  }

  double cost_of(const TubeSegment<N>& segment) const {
    double sum = 0;
    for (std::size_t g = 0; g < kGaussNodes.size(); ++g) {
      Vector x, dx;
      for (Index r = 0; r < N; ++r) {
        x[r] = segment.curve[static_cast<std::size_t>(r)].at(kGaussNodes[g]);
        dx[r] = segment.curve[static_cast<std::size_t>(r)].derivative().at(kGaussNodes[g]);
      }
      sum += kGaussWeights[g] * std::sqrt(dx.dot(metric_at(x) * dx));
    }
    return sum;
  }

  const TubeMetric<N>& metric_;
  const CoordinatePath& chain_;
  bool exists_ = false;
};

}  // namespace leastcost
