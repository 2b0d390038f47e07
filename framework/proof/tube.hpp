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
#include "framework/base/gauss.hpp"
#include "framework/proof/tube_field.hpp"
#include "framework/proof/tube_metric.hpp"
#include "framework/proof/tube_segment.hpp"

namespace leastcost {

/// The tube of framework/proof/calibration.hpp: the piecewise cubic curve with continuous tangents through the points
/// of a chain, its frame, and its width, segment by segment. A ring (N = 2 only) ends as it begins, or on the image of
/// that under a shift of the coordinates.
template <int N, int D>
class Tube {
 public:
  static constexpr int kAcross = N - 1;

  /// It reaches a part of one of `delivered` segments to each side. Throws Interrupted.
  Tube(const TubeMetric<N, D>& metric, const CoordinatePath& chain, Index delivered, const Deadline& deadline)
      : metric_(metric), chain_(chain) {
    exists_ = make_segments(delivered, deadline) && measure(deadline);
    if (exists_) set_widths(delivered);
  }

  /// False: too few points, or a metric that is not finite and positive definite on the curve (motion from rest, a
  /// pole).
  bool exists() const { return exists_; }

  bool ring() const { return chain_.ring; }

  std::vector<TubeSegment<N, D>> segments;
  std::optional<Index> torn;  ///< a segment without a tube, because the surface is no graph over it

  Eigen::VectorXd costs;   ///< of the curve in each segment, by Gauss' rule
  Eigen::VectorXd widths;  ///< half the width, units of the cost
  double cost = 0;         ///< of the curve

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

  /// Unit normals of the surface at all points; none for D = N.
  Points make_normals(const Deadline& deadline) const {
    Points normals(D, D > N ? chain_.u.cols() : 0);
    if constexpr (D > N)
      for (Index c = 0; c < normals.cols(); ++c) {
        look_at_clock(deadline);
        using Sloped = LevelSetEnclosure::Sloped;
        std::array<Sloped, D> at;
        for (std::size_t i = 0; i < D; ++i) {
          at[i] = Sloped(chain_.u(static_cast<Index>(i), c));
          at[i].d[i] = IntervalJet<N>(1.0);
        }
        const Sloped f = metric_.surface().enclose(std::span<const Sloped, D>(at));
        for (std::size_t i = 0; i < D; ++i) normals(static_cast<Index>(i), c) = f.d[i].value().middle();
        normals.col(c).normalize();
      }
    return normals;
  }

  /// The point i; in a ring also beyond its ends.
  Vector point(Index i) const { return chain_.column(i); }
  /// In a ring the number of the same point.
  Index same(Index i) const { return chain_.ring && i == chain_.u.cols() ? 0 : i; }

  /// d/di of what `at` gives for each point of a ring, of order 4.
  template <class At>
  static Vector slope_around(const At& at, Index i) {
    return (8 * (at(i + 1) - at(i - 1)) - (at(i + 2) - at(i - 2))) / 12;
  }

  /// dx/di of the points x at point i of an open chain, of order 4.
  static Vector slope(const Points& x, Index i) {
    static constexpr double kStencils[3][5] = {{-25. / 12, 4, -3, 4. / 3, -1. / 4},
                                               {-1. / 4, -5. / 6, 3. / 2, -1. / 2, 1. / 12},
                                               {1. / 12, -2. / 3, 0, 2. / 3, -1. / 12}};
    const Index last = x.cols() - 1;
    const bool mirrored = i > last / 2;
    const Index from_end = mirrored ? last - i : i;
    const Index row = std::min<Index>(from_end, 2), begin = from_end - row;
    Vector d = Vector::Zero();
    for (Index j = 0; j < 5; ++j) d += kStencils[row][j] * x.col(mirrored ? last - begin - j : begin + j);
    return mirrored ? Vector(-d) : d;
  }

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

  /// Of the unit normals.
  Vector turn_at(const Points& normals, Index i) const {
    const Index count = normals.cols();
    const auto around = [&](Index j) { return Vector(normals.col((j + count) % count)); };
    return chain_.ring ? slope_around(around, i) : slope(normals, i);
  }

  /// dx/di of the chain, in the tangent plane.
  Vector slope_at(const Points& normals, Index i) const {
    const auto around = [&](Index j) { return point(j); };
    Vector d = chain_.ring ? slope_around(around, i) : slope(chain_.u, i);
    if constexpr (D > N) d -= normals.col(i).dot(d) * normals.col(i);
    return d;
  }

  Frame first_frame(const Points& normals, const Vector& d) const {
    Frame seed = Frame::Zero();
    Index longest = 0;
    d.cwiseAbs().maxCoeff(&longest);
    for (int k = 0; k < kAcross; ++k) seed.col(k) = Vector::Unit((longest + 1 + k) % D);
    return next_frame(normals, 0, d, seed);
  }

  Frame next_frame(const Points& normals, Index i, const Vector& d, Frame before) const {
    if constexpr (D > N) before.col(0) = Vector(normals.col(i)).cross(d);
    return frame(metric_at(chain_.u.col(i)), d, before);
  }

  /// The part of a delivered segment that the tube reaches to each side, in coordinates.
  double reach(Index i, Index delivered) const {
    const double per_segment = static_cast<double>(chain_.segment_count()) / static_cast<double>(delivered);
    return kWidth * per_segment * (point(i + 1) - point(i)).norm();
  }

  bool make_segments(Index delivered, const Deadline& deadline) {
    const Index count = chain_.segment_count();
    if (count < 4) return false;
    const Points normals = make_normals(deadline);
    Vector d = slope_at(normals, 0);
    Frame across = first_frame(normals, d);
    segments.resize(static_cast<std::size_t>(count));
    for (Index i = 0; i < count; ++i) {
      look_at_clock(deadline);
      const Index after = same(i + 1);
      const Vector next_d = slope_at(normals, after), from = point(i), to = point(i + 1);
      const Frame next = next_frame(normals, after, next_d, across);
      if (!next.allFinite() || !across.allFinite()) {
        if constexpr (D > N)  // a singular point of the surface has no normal
          if (!(std::min(normals.col(i).norm(), normals.col(after).norm()) > 0.5)) torn = i;
        return false;
      }
      TubeSegment<N, D>& segment = segments[static_cast<std::size_t>(i)];
      if constexpr (D > N) {
        segment.reach = reach(i, delivered);
        const Vector turn = turn_at(normals, i), next_turn = turn_at(normals, after);
        for (Index r = 0; r < D; ++r)
          segment.normal[static_cast<std::size_t>(r)][0] =
              Cubic::hermite(normals(r, i), normals(r, after), turn[r], next_turn[r]);
      }
      for (Index r = 0; r < D; ++r) {
        const auto n = static_cast<std::size_t>(r);
        segment.curve[n] = Cubic::hermite(from[r], to[r], d[r], next_d[r]);
        for (Index k = 0; k < kAcross; ++k)
          segment.frame[n][static_cast<std::size_t>(k)] = Cubic::line(across(r, k), next(r, k));
      }
      d = next_d;
      across = next;
    }
    return true;
  }

  bool measure(const Deadline& deadline) {
    costs.resize(static_cast<Index>(segments.size()));
    const TubeField<N, D> field(metric_);
    for (Index i = 0; i < costs.size(); ++i) {
      look_at_clock(deadline);
      costs[i] = 0;
      for (std::size_t g = 0; g < kGaussNodes.size(); ++g) {
        const TubeSegment<N, D> here = segments[static_cast<std::size_t>(i)].around(kGaussNodes[g]);
        costs[i] += kGaussWeights[g] * field.on_curve(here, Interval(0)).speed.value().middle();
      }
      if (std::isfinite(costs[i]) || torn) continue;
      for (const double node : kGaussNodes)
        if (!field.lies_on_surface(segments[static_cast<std::size_t>(i)], node)) torn = i;
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
  bool exists_ = false;
};

}  // namespace leastcost
