// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include "framework/proof/calibration.hpp"

namespace leastcost {

/// Whether there can be a proof: cost and domain are formulas, in two or three coordinates, or the metric is constant
/// in a flat space of any number of them.
bool can_calibrate(const Problem& problem);

/// For a piecewise quintic curve with continuous curvature along an open chain or a ring, through as many of its points
/// as the shape of the curve and of the metric ask for: the time does not grow with the number of points. Throws
/// Interrupted.
Calibration calibrate(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                      const Deadline& deadline);

}  // namespace leastcost
