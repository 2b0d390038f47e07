// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost::bracket {

/// v = n0 r + r (g.d) / 2 - c r^3 around an end, with d the place less the end, r = |d|, in any number of dimensions;
/// `g` is the length of the slope.
struct ConeBound {
  double n0, g, c;
};

/// c of the cone within `reach` of the end, for n >= n0 + g.d - K r^2 / 2, K the curvature; infinite: there is none.
double cubic_of_cone(double n0, double g, double curvature, double reach);

/// Whether v rises along every ray up to `reach`: then |grad v| <= n there.
bool cone_rises(const ConeBound& cone, double reach);

/// v is at least this at the distance r from the end, in all directions.
double cone_at_least(const ConeBound& cone, double r);

}  // namespace leastcost::bracket
