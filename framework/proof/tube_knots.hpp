// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <leastcost/framework/path/path.hpp>
#include "framework/proof/chain_slopes.hpp"
#include "framework/proof/tube_segment.hpp"

namespace leastcost {

/// Which points of a chain are the joints of its tube. Between two of them the curve is a quintic; so a tube needs as
/// many segments as the shape of the curve and of the metric ask for, not as many as the chain has.
class TubeKnots {
 public:
  /// A few, and more where the curve would not follow the points in between: it would then be no extremal, and the gap
  /// of the proof larger than `enough`, relative to the cost.
  TubeKnots(const CoordinatePath& chain, double enough) : chain_(chain), slopes_(chain) {
    const Index count = chain.segment_count(), few = std::min(kFew, count);
    for (Index i = 0; i <= few; ++i) at_.push_back(i * count / few);
    std::vector<int> parts;
    do {
      parts.assign(segment_count(), 1);
      for (std::size_t n = 0; n < parts.size(); ++n) parts[n] = gap(n) > enough ? 2 : 1;
    } while (divide(parts));
  }

  std::size_t segment_count() const { return at_.size() - 1; }
  Index operator[](std::size_t n) const { return at_[n]; }
  /// Segments of the chain in one of the tube.
  Index stride(std::size_t n) const { return at_[n + 1] - at_[n]; }
  bool can_divide(std::size_t n) const { return stride(n) > 1; }

  /// Of the shorter segment at a joint.
  Index stride_at(std::size_t n) const {
    const std::size_t last = segment_count();
    const std::size_t before = n > 0         ? n - 1
                               : chain_.ring ? last - 1
                                             : 0,
                      after = n < last      ? n
                              : chain_.ring ? 0
                                            : last - 1;
    return std::min(stride(before), stride(after));
  }

  /// Each segment in so many parts, as far as the chain has points; false where that changes nothing.
  bool divide(const std::vector<int>& parts) {
    std::vector<Index> more{at_.front()};
    for (std::size_t n = 0; n < segment_count(); ++n) {
      const Index in = std::min<Index>(parts[n], stride(n));
      for (Index part = 1; part <= in; ++part) more.push_back(at_[n] + part * stride(n) / in);
    }
    const bool any = more.size() > at_.size();
    at_ = std::move(more);
    return any;
  }

 private:
  static constexpr Index kFew = 32;
  static constexpr double kMargin = 16;  ///< over one, for derivatives that are differences

  /// What a proof loses to the curve between two joints, about: by how much it misses the point in the middle is the
  /// 24th part of the second derivative of the miss, and so of its curvature, whose square is the gap.
  double gap(std::size_t n) const {
    if (!can_divide(n)) return 0;
    const Index from = at_[n], to = at_[n + 1], middle = (from + to) / 2;
    const double s = static_cast<double>(to - from), t = static_cast<double>(middle - from) / s;
    const auto values = [&](Index i) { return chain_.column(i); };
    const auto a = slopes_.at<Eigen::VectorXd>(from, stride_at(n), values),
               b = slopes_.at<Eigen::VectorXd>(chain_.ring ? to % chain_.u.cols() : to, stride_at(n + 1), values);
    const Eigen::VectorXd x = chain_.column(from), y = chain_.column(to), m = chain_.column(middle);
    double miss2 = 0;
    for (Index r = 0; r < x.size(); ++r) {
      const Quintic q = hermite(x[r], y[r], s * a.first[r], s * b.first[r], s * s * a.second[r], s * s * b.second[r]);
      miss2 += (q.at(t) - m[r]) * (q.at(t) - m[r]);
    }
    const double curvature = 24 * static_cast<double>(chain_.segment_count()) / s;  // in units of the cost of the path
    return kMargin * curvature * curvature * miss2 / (y - x).squaredNorm();
  }

  const CoordinatePath& chain_;
  ChainSlopes slopes_;
  std::vector<Index> at_;
};

}  // namespace leastcost
