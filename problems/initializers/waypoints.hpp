// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct WaypointsOptions {
  Eigen::MatrixXd points = {};  ///< one row per waypoint, ambient coordinates
  void fields(FieldVisitor& visit);
};

struct FileInitializerOptions {
  std::string file = {};
  void fields(FieldVisitor& visit);
};

/// A path through given points, in order: projected onto the domain and joined by the least-cost edge path on a mesh,
/// by straight moves elsewhere. In a ring the last is joined to the first.
class WaypointsInitializer final : public Initializer, public MakesRings {
 public:
  /// `waypoints`: d x m. Throws OptionError when there is none or a number is not finite.
  explicit WaypointsInitializer(Points waypoints);
  std::string_view name() const override { return "waypoints"; }
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  Points waypoints_;
};

}  // namespace leastcost
