// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Derivatives with respect to the number of a point of what is known at the points of a chain, by differences of up
/// to seven values; of order 5 and more where there are seven. Spread out, so that rounding weighs little, over about
/// as many points as a segment of a tube has.
class ChainSlopes {
 public:
  explicit ChainSlopes(const CoordinatePath& chain) : last_(chain.u.cols() - 1), ring_(chain.ring) {}

  template <class Vector>
  struct Slopes {
    Vector first, second;
  };

  /// Of `at(i)`, which in a ring is asked for beyond its ends as well. `stride`: points from one end of the shortest
  /// segment of the tube at point i to its other end.
  template <class Vector, class At>
  Slopes<Vector> at(Index i, Index stride, const At& values) const {
    const Index count = ring_ ? kMost : std::min<Index>(kMost, last_ + 1);
    const Index spread = std::clamp<Index>(stride / 3, 1, ring_ ? stride : last_ / (count - 1));
    const Index begin =
        ring_ ? i - spread * (count / 2) : std::clamp<Index>(i - spread * (count / 2), 0, last_ - spread * (count - 1));
    const Weights w = weights(begin - i, spread, count);
    const Vector zero = 0 * values(i);
    Slopes<Vector> out{zero, zero};
    for (Index j = 0; j < count; ++j) {
      const Vector value = values(begin + j * spread);
      out.first += w(j, 1) * value;
      out.second += w(j, 2) * value;
    }
    return out;
  }

 private:
  static constexpr Index kMost = 7;
  using Weights = Eigen::Matrix<double, kMost, 3>;

  /// Of the derivatives 0, 1 and 2 at 0, from values at first, first + spread, ... (Fornberg 1988).
  static Weights weights(Index first, Index spread, Index count) {
    const auto place = [&](Index j) { return static_cast<double>(first + j * spread); };
    Weights w = Weights::Zero();
    w(0, 0) = 1;
    double before = 1;
    for (Index j = 1; j < count; ++j) {
      double product = 1;
      for (Index k = 0; k < j; ++k) {
        const double apart = place(j) - place(k);
        product *= apart;
        if (k == j - 1)
          for (Index m = 2; m >= 0; --m)
            w(j, m) = before / product * ((m > 0 ? static_cast<double>(m) * w(k, m - 1) : 0) - place(k) * w(k, m));
        for (Index m = 2; m >= 0; --m)
          w(k, m) = (place(j) * w(k, m) - (m > 0 ? static_cast<double>(m) * w(k, m - 1) : 0)) / apart;
      }
      before = product;
    }
    return w;
  }

  Index last_;
  bool ring_;
};

}  // namespace leastcost
