// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cone_bound.hpp"

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {
namespace {

constexpr double kRoundedUp = 1 + 1e-12;

}  // namespace

double cubic_of_cone(double n0, double g, double curvature, double reach) {
  const double least = n0 - g * reach;
  if (!(least > 0)) return kInfinity;
  const double fixed = curvature / 6 + g * g / (24 * least);
  double c = fixed * kRoundedUp;
  constexpr int kRounds = 60;
  for (int i = 0; i < kRounds; ++i) {
    const double needed = (fixed + 1.5 * c * c * reach * reach / least) * kRoundedUp;
    if (c >= needed) return c;
    c = needed * 1.01;
  }
  return kInfinity;
}

bool cone_rises(const ConeBound& cone, double reach) {
  return cone.n0 - cone.g * reach - 3 * cone.c * reach * reach > 0;
}

double cone_at_least(const ConeBound& cone, double r) { return r * (cone.n0 - cone.g * r / 2 - cone.c * r * r); }

}  // namespace leastcost::bracket
