// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>

namespace leastcost {

/// The reference ellipsoid; default: WGS84.
struct EarthOptions {
  double semi_major_axis = 6378137;           ///< equatorial radius, m
  double inverse_flattening = 298.257223563;  ///< 1 / f; 0: a sphere
  void fields(FieldVisitor& visit);
};

/// The surface of the Earth, altitude 0. Points are (latitude, longitude) in degrees, geodetic, in the order of ISO
/// 6709 and EPSG:4326; places in space are geocentric (x to latitude and longitude 0, z to the north pole), m. The
/// chart goes on across the antimeridian and over the poles, like that of a parametric ellipsoid.
class EarthManifold final : public ParametricManifold, public IsGeographic {
 public:
  /// Throws OptionError.
  explicit EarthManifold(const EarthOptions& options = {});
  std::vector<std::string> coordinate_names() const override { return {"latitude", "longitude"}; }
  /// As those of the chart, each with the way there in words.
  std::vector<PointImage> images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                 std::size_t most) const override;
  Eigen::Vector2d longitude_latitude(const Eigen::VectorXd& u) const override { return {u[1], u[0]}; }
  Eigen::VectorXd coordinates_of(const Eigen::Vector2d& lonlat) const override { return lonlat.reverse(); }
};

}  // namespace leastcost
