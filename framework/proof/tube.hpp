// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include "framework/proof/chain_slopes.hpp"
#include "framework/proof/tube_field.hpp"
#include "framework/proof/tube_knots.hpp"
#include "framework/proof/tube_metric.hpp"
#include "framework/proof/tube_segment.hpp"

namespace leastcost {

/// The tube of framework/proof/calibration.hpp: the piecewise quintic curve with continuous curvature through some of
/// the points of a chain, its frame, and its width, segment by segment. A ring (N = 2 only) ends as it begins, or on
/// the image of that under a shift of the coordinates.
template <int N, int D>
class Tube {
 public:
  static constexpr int kAcross = N - 1;

  /// It reaches a part of one of `delivered` segments to each side. Throws Interrupted.
  Tube(const TubeMetric<N, D>& metric, const CoordinatePath& chain, const TubeKnots& knots, Index delivered,
       const Deadline& deadline)
      : metric_(metric), chain_(chain), knots_(knots), slopes_(chain) {
    exists_ = make_segments(delivered, deadline) && measure(deadline);
    if (exists_) set_widths(delivered);
  }

  /// False: too few points, or a metric that is not finite and positive definite on the curve (motion from rest, a
  /// pole).
  bool exists() const { return exists_; }

  bool ring() const { return chain_.ring; }

  std::vector<TubeSegment<N, D>> segments;
  std::optional<Index> torn;  ///< a segment without a tube, because the surface is no graph over it

  Eigen::VectorXd costs;   ///< of the curve in each segment, about: by the midpoint rule
  Eigen::VectorXd widths;  ///< half the width, units of the cost
  double cost = 0;         ///< of the curve, about

 private:
  using Vector = Eigen::Matrix<double, D, 1>;
  using Square = Eigen::Matrix<double, D, D>;
  using Frame = Eigen::Matrix<double, D, kAcross>;
  static constexpr double kWidth = 0.25;  ///< of a segment, to each side

  Square metric_at(const Eigen::VectorXd& x) const {
    JetPoint<N, D> at;
    for (std::size_t i = 0; i < D; ++i) at[i] = IntervalJet<N>(x[static_cast<Index>(i)]);
    const JetMatrix<N, D> g = metric_(at);
    Square out;
    for (Index i = 0; i < D; ++i)
      for (Index j = 0; j < D; ++j) out(i, j) = g[static_cast<std::size_t>(D * i + j)].value().middle();
    return out;
  }

  /// Unit normal of the surface at point i; in a ring also beyond its ends. Zero at a singular point.
  Vector normal(Index i) const {
    if constexpr (D > N) {
      using Sloped = LevelSetEnclosure::Sloped;
      const Vector x = point(i);
      std::array<Sloped, D> at;
      for (std::size_t r = 0; r < D; ++r) {
        at[r] = Sloped(x[static_cast<Index>(r)]);
        at[r].d[r] = IntervalJet<N>(1.0);
      }
      const Sloped f = metric_.surface().enclose(std::span<const Sloped, D>(at));
      Vector n;
      for (std::size_t r = 0; r < D; ++r) n[static_cast<Index>(r)] = f.d[r].value().middle();
      return n.normalized();
    } else {
      return Vector::Zero();
    }
  }

  /// The point i; in a ring also beyond its ends.
  Vector point(Index i) const { return chain_.column(i); }
  double stride(Index i) const { return static_cast<double>(knots_.stride(static_cast<std::size_t>(i))); }

  /// A frame across d that is orthonormal under g, as little turned from `before` as can be.
  static Frame frame(const Square& g, const Vector& d, const Frame& before) {
    Frame out;
    const Vector gd = g * d;
    if constexpr (D == 2) {
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

  /// What the curve is made of at a joint: derivatives with respect to the number of a point.
  struct Joint {
    Vector x, d, dd;
    Vector normal, turn;  ///< of a surface
    Frame across;
  };

  Joint joint(std::size_t n, const Joint* before) const {
    const Index i = knots_[n], stride = knots_.stride_at(n);
    Joint out;
    out.x = point(i);
    // Of a ring the last joint is the first one, up to a shift.
    const Index same = chain_.ring ? i % chain_.u.cols() : i;
    const auto slopes = slopes_.at<Vector>(same, stride, [&](Index j) { return point(j); });
    out.d = slopes.first;
    out.dd = slopes.second;
    if constexpr (D > N) {
      out.normal = normal(same);
      out.turn = slopes_.at<Vector>(same, stride, [&](Index j) { return normal(j); }).first;
      out.d -= out.normal.dot(out.d) * out.normal;
    }
    Frame seed = before != nullptr ? before->across : first_seed(out.d);
    if constexpr (D > N) seed.col(0) = out.normal.cross(out.d);
    out.across = frame(metric_at(out.x), out.d, seed);
    return out;
  }

  static Frame first_seed(const Vector& d) {
    Frame seed = Frame::Zero();
    Index longest = 0;
    d.cwiseAbs().maxCoeff(&longest);
    for (int k = 0; k < kAcross; ++k) seed.col(k) = Vector::Unit((longest + 1 + k) % D);
    return seed;
  }

  /// The part of a delivered segment that the tube reaches to each side, in coordinates.
  double reach(Index i, Index delivered) const {
    const auto n = static_cast<std::size_t>(i);
    const double per_segment = static_cast<double>(chain_.segment_count()) / static_cast<double>(delivered) / stride(i);
    return kWidth * per_segment * (point(knots_[n + 1]) - point(knots_[n])).norm();
  }

  bool make_segments(Index delivered, const Deadline& deadline) {
    if (chain_.segment_count() < 4) return false;
    segments.resize(knots_.segment_count());
    Joint from = joint(0, nullptr);
    for (Index i = 0; i < static_cast<Index>(segments.size()); ++i) {
      look_at_clock(deadline);
      const Joint to = joint(static_cast<std::size_t>(i) + 1, &from);
      if (!to.across.allFinite() || !from.across.allFinite()) {
        if constexpr (D > N)  // a singular point of the surface has no normal
          if (!(std::min(from.normal.norm(), to.normal.norm()) > 0.5)) torn = i;
        return false;
      }
      connect(segments[static_cast<std::size_t>(i)], from, to, stride(i), reach(i, delivered));
      from = to;
    }
    return true;
  }

  /// A segment of `s` of the chain.
  static void connect(TubeSegment<N, D>& segment, const Joint& from, const Joint& to, double s, double reach) {
    if constexpr (D > N) {
      segment.reach = reach;
      for (Index r = 0; r < D; ++r)
        segment.normal[static_cast<std::size_t>(r)][0] =
            hermite(from.normal[r], to.normal[r], s * from.turn[r], s * to.turn[r]);
    }
    for (Index r = 0; r < D; ++r) {
      const auto n = static_cast<std::size_t>(r);
      segment.curve[n] = hermite(from.x[r], to.x[r], s * from.d[r], s * to.d[r], s * s * from.dd[r], s * s * to.dd[r]);
      for (Index k = 0; k < kAcross; ++k)
        segment.frame[n][static_cast<std::size_t>(k)] = line(from.across(r, k), to.across(r, k));
    }
  }

  bool measure(const Deadline& deadline) {
    costs.resize(static_cast<Index>(segments.size()));
    const TubeField<N, D> field(metric_);
    for (Index i = 0; i < costs.size(); ++i) {
      look_at_clock(deadline);
      const TubeSegment<N, D> middle = segments[static_cast<std::size_t>(i)].around(0.5);
      costs[i] = field.on_curve(middle, Interval(0)).speed.value().middle();
      if (std::isfinite(costs[i]) || torn) continue;
      if (!field.lies_on_surface(segments[static_cast<std::size_t>(i)], 0.5)) torn = i;
    }
    cost = costs.sum();
    return std::isfinite(cost);
  }

  /// Half the width of the tube at each segment, in units of the cost: a part of a segment, both in cost and in
  /// coordinates, so that no soft direction makes it reach far.
  void set_widths(Index delivered) {
    widths.resize(costs.size());
    for (Index i = 0; i < costs.size(); ++i) {
      const TubeSegment<N, D>& segment = segments[static_cast<std::size_t>(i)];
      double longest2 = 0;
      for (std::size_t k = 0; k < kAcross; ++k) {
        double length2 = 0;
        for (const auto& row : segment.frame) length2 += row[k].c[0] * row[k].c[0];
        longest2 = std::max(longest2, length2);
      }
      widths[i] = std::min(kWidth * cost / static_cast<double>(delivered), reach(i, delivered) / std::sqrt(longest2));
    }
  }

  const TubeMetric<N, D>& metric_;
  const CoordinatePath& chain_;
  const TubeKnots& knots_;
  ChainSlopes slopes_;
  bool exists_ = false;
};

}  // namespace leastcost
