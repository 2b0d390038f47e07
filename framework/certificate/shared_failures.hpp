// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/certificate/certificate.hpp>

namespace leastcost {

/// Relative error bar above which a path on a polyhedron, or one that was straightened, is not certified.
inline constexpr double kPolyhedronError = 0.01;
/// How unequal the segments of an unstraightened path on a polyhedron may be.
inline constexpr double kPolyhedronSpacing = 0.05;

/// Refuses a path for the spacing that was measured, beyond `allowed`.
void fail_spacing(Certificate& c, double allowed);

/// Refuses a path whose measured relative cost error is beyond `allowed`, or no number.
void check_stationarity(Certificate& c, double allowed);

}  // namespace leastcost
