// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include <leastcost/framework/domain/encloses_level_set.hpp>
#include <leastcost/framework/numbers/implicit_function.hpp>
#include "framework/proof/tube_segment.hpp"

namespace leastcost {

/// The part of a surface F = 0 that lies beside a segment of a tube, as a graph over its plane: the height h(t, z) with
/// F(gamma(t) + z n(t) + h normal(t)) = 0. By the interval Newton method: where it contracts there is exactly one such
/// height within the reach of the tube for every (t, z) of the box, one sheet and no second one.
class TubeGraph {
 public:
  using Segment = TubeSegment<2, 3>;
  using Jet = IntervalJet<2>;

  /// The function must outlive this object.
  explicit TubeGraph(const LevelSetEnclosure& function) : function_(function) {}

  /// Unknown where that fails. t and z: variables 0 and 1; a constant z is none.
  Jet height(const Segment& segment, const Interval& t, const Jet& z) const {
    const Beside box(function_, segment, t, z.value(), z.is_constant());
    const Interval all(-segment.reach, segment.reach), first = box.newton(all, box.at(all));
    if (!(all.lo < first.lo && first.hi < all.hi)) return Jet::unknown();
    const IntervalJet<3> over_box = box.at(first);
    const Interval h = common(first, box.newton(first, over_box));
    const Beside center(function_, segment, Interval(t.middle()), Interval(z.value().middle()), z.is_constant());
    const Interval at_center = common(h, center.newton(h, center.at(h)));
    return Jet::from(implicit_function(over_box.derivatives(), h),
                     implicit_function(center.at(at_center).derivatives(), at_center), {t, z.value()});
  }

 private:
  /// F as a function of t, z and h.
  class Beside {
   public:
    Beside(const LevelSetEnclosure& function, const Segment& segment, const Interval& t, const Interval& z,
           bool constant)
        : function_(function) {
      using Jet3 = IntervalJet<3>;
      const Jet3 across = constant ? Jet3(z) : Jet3::variable(z, 1);
      for (std::size_t i = 0; i < 3; ++i) {
        base_[i] = segment.curve[i].jet<3>(t) + segment.frame[i][0].jet<3>(t) * across;
        normal_[i] = segment.normal[i][0].jet<3>(t);
      }
    }

    IntervalJet<3> at(const Interval& h) const {
      const auto height = IntervalJet<3>::variable(h, 2);
      std::array<IntervalJet<3>, 3> x;
      for (std::size_t i = 0; i < 3; ++i) x[i] = base_[i] + normal_[i] * height;
      return function_.enclose(std::span<const IntervalJet<3>, 3>(x)).tighten();
    }
    /// The heights in h, or none where it is empty; `there` is F over all of h.
    Interval newton(const Interval& h, const IntervalJet<3>& there) const {
      const Interval middle(h.middle());
      return middle - at(middle).value() / there.d(2);
    }

   private:
    const LevelSetEnclosure& function_;
    std::array<IntervalJet<3>, 3> base_, normal_;
  };

  static Interval common(const Interval& a, const Interval& b) {
    const Interval both(std::max(a.lo, b.lo), std::min(a.hi, b.hi));
    return both.lo <= both.hi ? both : a;  // rounding
  }

  const LevelSetEnclosure& function_;
};

}  // namespace leastcost
