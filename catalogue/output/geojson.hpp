// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run.hpp>

namespace leastcost {

/// (longitude, latitude) in degrees, from -180 to 180 and from -90 to 90.
using GeographicLine = std::vector<Eigen::Vector2d>;

/// A line over places (longitude, latitude) on the universal cover, straight between them, cut at the antimeridian (RFC
/// 7946 Sec. 3.1.9) and at the poles.
std::vector<GeographicLine> geographic_lines(const std::vector<Eigen::Vector2d>& cover);

/// path.geojson, RFC 7946: the delivered path as a line through its points. Empty where neither the domain nor the cost
/// is on the Earth (IsGeographic), or there is no path.
std::string geojson_text(const RunOutcome& outcome);

/// path_points.geojson: its points, apart, so that each file is a layer of one type of geometry.
std::string geojson_points_text(const RunOutcome& outcome);

}  // namespace leastcost
