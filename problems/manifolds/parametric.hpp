// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/options.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/chart_map.hpp>

namespace leastcost {

/// A surface by name with its measures, or by formulas.
struct ParametricOptions {
  std::string type = {};
  double radius = 1;                                ///< sphere, cylinder
  Eigen::VectorXd axes = Eigen::Vector3d(3, 2, 1);  ///< ellipsoid
  double major_radius = 2, minor_radius = 1;        ///< torus, klein_bottle
  double half_angle = 0.5;                          ///< cone, radians
  double waist = 1, height = 1;                     ///< catenoid, hyperboloid
  double curvature = 1;                             ///< paraboloid
  double half_width = 0.5;                          ///< moebius_strip
  double pitch = 1;                                 ///< spiral
  std::string x = {}, y = {}, z = {};               ///< formula
  std::map<std::string, double> parameters = {};    ///< formula
  double period_u = 0, period_v = 0;                ///< formula
  bool twisted = false;                             ///< formula
  BoxOptions box = {};
  void fields(FieldVisitor& visit);
};

/// A surface x(u, v) in R^3 (VFCS 4.4.1, Eq. 12). The chart's coordinates are the unknowns; they lie on the universal
/// cover, so that paths cross seams and poles and keep their winding. The edges of the chart (an apex, a rim) are
/// bounds.
class ParametricManifold final : public ConstraintManifold, public HasChart, public HasBounds, public HasSeams {
 public:
  ParametricManifold(std::shared_ptr<const ChartMap> map, Box box, std::vector<Seam> seams,
                     std::vector<SeamMap> poles = {});

  Dimensions dimensions() const override { return {2, 3, 2}; }
  Shape shape() const override { return Shape::smooth; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  /// Farthest that a column lies beyond the edges of the chart, in coordinates.
  double residual(const CoordinatePath& path) const override;
  void embed(const CoordinatePath& path, Points& x) const override;
  void jacobians(const CoordinatePath& path, Points& j) const override;
  void curvatures(const CoordinatePath& path, const Points& weights, Points& h) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  const std::vector<Seam>& seams() const override { return seams_; }
  const std::vector<SeamMap>& poles() const override { return poles_; }

 private:
  std::shared_ptr<const ChartMap> map_;
  Box box_;
  std::vector<Seam> seams_;
  std::vector<SeamMap> poles_;
};

/// Throws OptionError.
std::shared_ptr<const ParametricManifold> make_parametric_manifold(const ParametricOptions& options);

}  // namespace leastcost
