// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Ability: points of the domain are places on the Earth (or on another planet).
class IsGeographic {
 public:
  virtual ~IsGeographic() = default;
  bool present() const { return is_geographic(); }
  /// Geodetic longitude and latitude of coordinates u, degrees, in this order (that of x and y). On the universal
  /// cover: longitudes beyond 180 and latitudes beyond 90 stand for what lies beyond the seam and the poles.
  virtual Eigen::Vector2d longitude_latitude(const Eigen::VectorXd& u) const = 0;

  /// Coordinates of a geodetic longitude and latitude, degrees; not finite where there are none.
  virtual Eigen::VectorXd coordinates_of(const Eigen::Vector2d& longitude_latitude) const = 0;

  /// What a user should know about them; may be empty.
  virtual std::string place_note() const { return ""; }

 private:
  virtual bool is_geographic() const { return true; }
};

}  // namespace leastcost
