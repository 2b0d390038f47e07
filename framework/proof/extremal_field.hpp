// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include "framework/proof/riccati_point.hpp"
#include "framework/proof/tube.hpp"

namespace leastcost {

/// The potential of a tube: W by its Riccati equation, with the largest margin of a few that leaves it bounded. Written
/// into the segments of the tube. Of a ring W must not be less after one turn than it was before, and what it is more
/// is a step of the potential upward, where the ring closes.
template <int N, int D>
class ExtremalField {
 public:
  static constexpr int kAcross = N - 1;

  /// Throws Interrupted.
  ExtremalField(const TubeField<N, D>& field, Tube<N, D>& tube, const Deadline& deadline)
      : field_(field), tube_(tube), deadline_(deadline) {
    for (const TubeSegment<N, D>& segment : tube_.segments) {
      look_at_clock(deadline_);
      for (const double t : {0.0, 0.5, 1.0}) riccati_.emplace_back(field_, segment, t);
    }
    exists_ = solve();
  }

  /// Of an open path. Adds third derivatives to the potential, so that those of f vanish on the curve: f then falls on
  /// both sides farther out where it is lopsided, and less far where these derivatives grow along the path. Throws
  /// Interrupted.
  void add_third_derivatives();

  /// False: the path is no strict minimum, or nearly not.
  bool exists() const { return exists_; }
  /// The Hessian of f across the curve is -2m there, m at least this. Per square of the cost.
  double margin() const { return margin_; }

  /// Whether u varies across the curve, at the joints of the tube, by less than a quarter of the least segment. Of each
  /// segment a path then pays du (1 - e / 2), and what it gains by crossing joints away from the curve, where e differs
  /// on both sides, is less than half of the sum of e du.
  bool varies_little_across() const {
    double most = 0;
    for (std::size_t i = 0; i < tube_.segments.size(); ++i) {
      const double r = tube_.widths[static_cast<Index>(i)] * std::sqrt(static_cast<double>(kAcross));
      double w = 0, third = 0;
      for (std::size_t k = 0; k < kAcross; ++k)
        for (std::size_t l = 0; l < kAcross; ++l) {
          w += std::abs(tube_.segments[i].w[k][l].c[0]);
          for (std::size_t m = 0; m < kAcross; ++m) third += std::abs(tube_.segments[i].third[k][l][m].c[0]);
        }
      most = std::max(most, r * (riccati_[3 * i].momentum_across() + r * (w / 2 + r * third / 6)));
    }
    return most <= tube_.costs.minCoeff() / 4;
  }

 private:
  using Small = Eigen::Matrix<double, kAcross, kAcross>;
  static constexpr std::size_t kSegmentsAtOnce = 64;  ///< between two looks at the clock

  bool solve() {
    const double unit = std::numbers::pi / tube_.cost;
    for (const double own : {1.0, 0.25, 0.0}) {
      own_part_ = own;
      const double least = tube_.ring() ? 1e-5 : 1e-2;
      for (double part = 64; part > least; part /= 2) {
        margin_ = part * unit * unit;
        if (!found()) continue;
        margin_ /= 4;
        return found();
      }
    }
    return false;
  }

  bool found() { return tube_.ring() ? closes() : flattest(); }

  /// Of a ring: whether some W is not less after one turn, by more than rounding. Turn after turn a large start comes
  /// down to the largest W that is periodic, if there is one; what starts less comes nearer to it.
  bool closes() {
    constexpr int kTurns = 40;
    constexpr double kBelow = 1e-3, kRounding = 1e-9, kPerSegment = 0.5;  // more is no step for the integration
    const double unit = std::numbers::pi / tube_.cost;
    double start = kPerSegment * static_cast<double>(tube_.segments.size()) / tube_.cost;
    for (int turn = 0; turn < kTurns; ++turn) {
      if (!std::isfinite(integrate(start))) return false;
      const double fall = start - end_;
      start = end_;
      if (std::abs(fall) <= kRounding * unit) break;
    }
    for (double below = kBelow; below < 1; below *= 2) {
      const double less = start - below * std::max(std::abs(start), 1e-3 * unit);
      if (std::isfinite(integrate(less)) && end_ - less > kRounding * unit) return small_where_it_closes();
    }
    return false;
  }

  /// The potential varies little across where the ring closes, in units of its cost.
  bool small_where_it_closes() const {
    constexpr double kLittle = 0.25;
    const double width = tube_.widths[0], w = std::max(std::abs(tube_.segments.front().w[0][0].at(0)), std::abs(end_));
    return w * width * width / 2 < kLittle * tube_.cost;
  }

  /// Whether W stays bounded from some start; from the one that keeps it smallest.
  bool flattest() {
    const double unit = std::numbers::pi / tube_.cost;
    double best = std::numeric_limits<double>::infinity(), from = 0;
    for (double start = unit / 4; start < 64 * unit; start *= 1.5) {
      const double size = integrate(start);
      if (size < best) best = size, from = start;
    }
    return std::isfinite(best) && std::isfinite(integrate(from));
  }

  /// W from `start` times the identity; its largest entry, infinite where it does not stay bounded.
  double integrate(double start) {
    Small w = start * Small::Identity();
    const double most = 4 * static_cast<double>(tube_.segments.size()) / tube_.cost + 100 * start;
    double largest = start;
    for (std::size_t i = 0; i < tube_.segments.size(); ++i) {
      if (i % kSegmentsAtOnce == 0) look_at_clock(deadline_);
      const RiccatiPoint<N, D>* at = &riccati_[3 * i];
      const Small k1 = at[0].rate(w, margin_, own_part_), k2 = at[1].rate(w + k1 / 2, margin_, own_part_),
                  k3 = at[1].rate(w + k2 / 2, margin_, own_part_), k4 = at[2].rate(w + k3, margin_, own_part_);
      Small next = w + (k1 + 2 * k2 + 2 * k3 + k4) / 6;
      next = (0.5 * (next + next.transpose())).eval();
      largest = std::max(largest, next.cwiseAbs().maxCoeff());
      if (!(largest <= most)) return std::numeric_limits<double>::infinity();
      const Small rate = at[2].rate(next, margin_, own_part_);
      for (Index r = 0; r < kAcross; ++r)
        for (Index c = 0; c < kAcross; ++c)
          tube_.segments[i].w[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] =
              hermite(w(r, c), next(r, c), k1(r, c), rate(r, c));
      w = next;
    }
    end_ = w(0, 0);
    return largest;
  }

  const TubeField<N, D>& field_;
  Tube<N, D>& tube_;
  const Deadline& deadline_;
  std::vector<RiccatiPoint<N, D>> riccati_;  ///< at the start, the middle and the end of each segment
  double margin_ = 0, own_part_ = 1;
  double end_ = 0;  ///< W(0, 0) at the end of the path
  bool exists_ = false;
};

template <int N, int D>
void ExtremalField<N, D>::add_third_derivatives() {
  using Cube = typename RiccatiPoint<N, D>::Cube;
  const auto plus = [](const Cube& a, const Cube& b, double factor) {
    Cube sum;
    for (std::size_t k = 0; k < kAcross; ++k) sum[k] = a[k] + factor * b[k];
    return sum;
  };
  Cube c;
  c.fill(Small::Zero());
  for (std::size_t i = 0; i < tube_.segments.size(); ++i) {
    look_at_clock(deadline_);
    std::array<Cube, 3> rest;
    std::array<Small, 3> w;
    for (int stage = 0; stage < 3; ++stage) {
      const TubeSegment<N, D> here = tube_.segments[i].around(stage / 2.0);
      const IntervalJet<N> f = field_.squared_norm(here, field_.on_curve(here, Interval(0)), Interval(0), {});
      const auto s = static_cast<std::size_t>(stage);
      for (int k = 0; k < kAcross; ++k)
        for (int l = 0; l < kAcross; ++l) {
          w[s](k, l) = here.w[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)].c[0];
          for (int m = 0; m < kAcross; ++m)
            rest[s][static_cast<std::size_t>(k)](l, m) = f.d(k + 1, l + 1, m + 1).middle();
        }
    }
    const RiccatiPoint<N, D>* at = &riccati_[3 * i];
    const Cube k1 = at[0].third_rate(w[0], c, rest[0]), k2 = at[1].third_rate(w[1], plus(c, k1, 0.5), rest[1]),
               k3 = at[1].third_rate(w[1], plus(c, k2, 0.5), rest[1]),
               k4 = at[2].third_rate(w[2], plus(c, k3, 1), rest[2]);
    const Cube next = plus(plus(plus(plus(c, k1, 1. / 6), k2, 1. / 3), k3, 1. / 3), k4, 1. / 6);
    const Cube rate = at[2].third_rate(w[2], next, rest[2]);
    for (std::size_t k = 0; k < kAcross; ++k)
      for (Index l = 0; l < kAcross; ++l)
        for (Index m = 0; m < kAcross; ++m)
          tube_.segments[i].third[k][static_cast<std::size_t>(l)][static_cast<std::size_t>(m)] =
              hermite(c[k](l, m), next[k](l, m), k1[k](l, m), rate[k](l, m));
    c = next;
  }
}

}  // namespace leastcost
