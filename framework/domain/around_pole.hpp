// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// Coordinates that are smooth at a pole of a chart: the pole is the origin, the distance from it the coordinate that
/// turns over there, the direction the one that turns around it (the azimuthal equidistant map of a sphere).
class AroundPole {
 public:
  /// Of the pole near which one of the columns of u lies; nothing where none does, and for charts of another kind.
  static std::optional<AroundPole> of(const HasChart& chart, const Points& u);

  /// Points of the chart in these coordinates, 2 x columns.
  Points flat(const Points& u) const;
  /// A point p and a velocity dp in these coordinates as those of the chart.
  void chart_of(const Eigen::Vector2d& p, const Eigen::Vector2d& dp, Eigen::Vector2d& u,
                Eigen::Vector2d& velocity) const;

 private:
  Index distance_ = 0, turn_ = 1;  ///< which coordinate is which
  double at_ = 0;                  ///< the pole, in the first
  double scale_ = 1;               ///< radians of a unit of the coordinates
  double side_ = 1;                ///< of the pole, on which the chart lies
};

}  // namespace leastcost
