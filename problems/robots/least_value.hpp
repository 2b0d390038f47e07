// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace leastcost {

/// A value of a function on [0, 1], and where it attains it.
struct ValueAt {
  double value = 0, at = 0;
};

/// A value that f attains on [0, 1], the least as far as `places` of them and the valley of the lowest show: golden
/// sections and parabolas through three places, to `near` in t (Brent 1973): by default half the digits, hence all of
/// them in f.
template <class Function>
ValueAt least_value(const Function& f, int places, double near = 2e-9) {
  constexpr int kMostSteps = 40;
  constexpr double kGolden = 0.38196601125010515;  // (3 - sqrt 5) / 2
  double x = 0, fx = f(0.0), last = fx;
  double w = x, v = x, fw = fx, fv = fx;  // its neighbours, if it has two
  for (int k = 1; k <= places; ++k) {
    const double t = static_cast<double>(k) / places, ft = f(t);
    if (ft < fx) {
      w = static_cast<double>(k - 1) / places, fw = last;
      v = x = t, fv = fx = ft;
    } else if (t - x < 1.5 / places) {
      v = t, fv = ft;
    }
    last = ft;
  }
  const bool inside = w < x && x < v;
  if (!inside) w = v = x, fw = fv = fx;
  if (fv < fw) std::swap(w, v), std::swap(fw, fv);
  double from = std::max(0.0, x - 1.0 / places), to = std::min(1.0, x + 1.0 / places);
  double step = inside ? 1.0 / places : 0, before = step;
  for (int k = 0; k < kMostSteps; ++k) {
    const double middle = (from + to) / 2;
    if (std::abs(x - middle) <= 2 * near - (to - from) / 2) break;
    const double r = (x - w) * (fx - fv);
    double q = (x - v) * (fx - fw), p = (x - v) * q - (x - w) * r;
    q = 2 * (q - r);
    if (q > 0) p = -p;
    q = std::abs(q);
    const bool parabola = std::abs(p) < std::abs(q * before / 2) && p > q * (from - x) && p < q * (to - x);
    before = parabola ? step : (x < middle ? to - x : from - x);
    step = parabola ? p / q : kGolden * before;
    const double u = x + (std::abs(step) >= near ? step : std::copysign(near, step));
    const double t = std::clamp(u, 0.0, 1.0), ft = f(t);
    if (ft <= fx) {
      (t < x ? to : from) = x;
      v = w, fv = fw, w = x, fw = fx, x = t, fx = ft;
    } else {
      (t < x ? from : to) = t;
      if (ft <= fw || w == x) {
        v = w, fv = fw, w = t, fw = ft;
      } else if (ft <= fv || v == x || v == w) {
        v = t, fv = ft;
      }
    }
  }
  return {fx, x};
}

}  // namespace leastcost
