// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Cost of the smooth curve through the points of a chain on a flat domain or a chart (in coordinates): on each segment
/// the cubic through its four nearest points, the line element integrated with 5-point Gauss. A feasible curve, hence
/// an upper bound; order 4 at least where the chain has 2. Where the cubic leaves the domain (beside a bound on which
/// the points rest) its projection takes its place. Nothing where the line element is singular (a bead at rest).
std::optional<double> smooth_curve_cost(const Problem& problem, const CoordinatePath& path,
                                        const Deadline& deadline = {});

/// Where a chain in a chart jumps: the largest ratio of what the straight move in coordinates between two neighbours
/// costs to what the chain pays for the chord. It tends to 1 with the step. Far above 1 the chord cuts through space
/// beside the surface, around a hole of the chart say, and the chain is no path of the chart's class. A move over a
/// pole may be straight towards the image of a point instead, one beside a pole bent towards it.
inline constexpr double kChartJump = 1.3;  ///< from here on a chain jumps: pi / 2 is one around a pole
struct ChartJump {
  double ratio = 1;
  Index segment = -1;
};
ChartJump worst_chart_jump(const Problem& problem, const CoordinatePath& path, const Eigen::VectorXd& costs,
                           const Deadline& deadline = {});

}  // namespace leastcost
