// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/spline_check.hpp"

#include <algorithm>
#include <cmath>

namespace leastcost::bracket {
namespace {

/// The nets of a gradient and of what it has to stay below, the last one.
template <int N>
using GradientAndFloor = std::array<Net<N>, static_cast<std::size_t>(N) + 1>;

/// Ratios of control vectors to the floor, in the units of the nets: gradient times side.
template <int N>
struct Comparison {
  double side, slack;
  const CheckRules<N>& rules;
  const Blocked<N>& blocked;

  double whole(const GradientAndFloor<N>& nets) const {
    double worst = 0, least = kInfinity;
    for (std::size_t k = 0; k < nets[0].size(); ++k) {
      if (rules.dropped >> k & 1U) continue;
      double length = nets[0][k] * nets[0][k] + nets[1][k] * nets[1][k];  // squared
      if constexpr (N == 3) length += nets[2][k] * nets[2][k];
      const double floor = nets.back()[k];
      worst = larger_or_nan(worst, length / (floor * floor));
      least = floor >= least ? least : floor;
    }
    const double ratio = (std::sqrt(worst) * (1 + 8 * kEps) + slack / least) / side;
    return least > 0 && ratio < kInfinity ? ratio : kInfinity;
  }

  double proved(const GradientAndFloor<N>& nets, const CellPart<N>& part) const {
    constexpr double kHopeless = 1.1;  // halves do not help where it is the gradient itself that is too long
    if (blocked.any() && blocked.holds(part)) return 0;
    const double as_it_is = whole(nets);
    if (as_it_is <= 1) return as_it_is;
    if (blocked.any() ? part.level == BlockedParts::kLevels : part.level == rules.halvings || !(as_it_is < kHopeless))
      return as_it_is;
    double worst = 0;
    for_halves<N>(nets, [&](const GradientAndFloor<N>& of_half, const Place<N>& half) {
      worst = std::max(worst, proved(of_half, part.half(half)));
    });
    return std::min(worst, as_it_is);
  }
};

}  // namespace

template <int N>
double proved_ratio(const Net<N>& coefficients, double h, double largest, const Net<N>& floor,
                    const CheckRules<N>& rules, const Blocked<N>& blocked) {
  const auto gradient = gradient_nets<N>(coefficients);
  GradientAndFloor<N> nets;
  std::copy(gradient.begin(), gradient.end(), nets.begin());
  nets.back() = floor;
  // Each control vector is the end of at most sixteen sums and averages of numbers up to 2 |u|.
  const double slack = rules.rounding * 64 * kEps * largest;
  return Comparison<N>{h, slack, rules, blocked}.proved(nets, {}) * (1 + 64 * rules.rounding * kEps);
}

template double proved_ratio<2>(const Net<2>&, double, double, const Net<2>&, const CheckRules<2>&, const Blocked<2>&);
template double proved_ratio<3>(const Net<3>&, double, double, const Net<3>&, const CheckRules<3>&, const Blocked<3>&);

}  // namespace leastcost::bracket
