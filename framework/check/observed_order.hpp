// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace leastcost {

/// Order at which error(h) falls when h is halved: the median of the last four slopes above the floor of rounding, or
/// of the four before those (a change of sign can spoil one window). +infinity where the errors vanish: an exact
/// derivative of a polynomial, a clamp that is no longer reached. A derivative is right when the Taylor error of degree
/// p falls at order p + 1; one finite difference would only say that it is not grossly wrong.
template <class Error>
double observed_order(Error error, double first_step, double floor, int halvings = 20) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> slopes;
  double before = kInfinity;
  for (int k = 0; k < halvings; ++k, first_step /= 2) {
    const double e = std::abs(error(first_step));
    if (std::isnan(e)) return -kInfinity;
    if (e <= floor && before > 1e3 * floor) return kInfinity;
    if (e <= floor) break;
    if (k > 0) slopes.push_back(std::log2(before / e));
    before = e;
  }
  double best = -kInfinity;
  for (const std::size_t skipped : {0u, 4u}) {
    if (slopes.size() <= skipped) break;
    const auto end = slopes.end() - static_cast<std::ptrdiff_t>(skipped);
    std::vector<double> window(end - std::min<std::ptrdiff_t>(4, end - slopes.begin()), end);
    std::sort(window.begin(), window.end());
    best = std::max(best, window[window.size() / 2]);
  }
  return best;
}

/// What an order may fall short of by when it is measured over a few halvings.
inline constexpr double kOrderSlack = 0.3;

}  // namespace leastcost
