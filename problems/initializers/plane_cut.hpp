// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct PlaneCutOptions {
  Eigen::VectorXd point = {};   ///< in the plane, ambient coordinates
  Eigen::VectorXd normal = {};  ///< of any length but zero
  void fields(FieldVisitor& visit);
};

/// A first ring (VFCS 6.1): the closed curve in which a plane cuts a surface in R^3; of several the one nearest to the
/// given point, on a smooth surface one near to it (smooth_section). Vertices, edges and faces that lie in the plane
/// are no trouble. Throws InitializationError where the plane misses the surface, touches it only, or cuts it in no
/// closed curve, and where the path is no ring; InputError where the domain is no surface.
class PlaneCutInitializer final : public Initializer, public MakesRings {
 public:
  /// Throws OptionError for a point or normal that is not three finite numbers, and for a zero normal.
  explicit PlaneCutInitializer(const PlaneCutOptions& options);
  std::string_view name() const override { return "plane_cut"; }
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  Eigen::Vector3d point_, normal_;
};

}  // namespace leastcost
