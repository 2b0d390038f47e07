// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/domain/encloses_chart.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/chart_map.hpp>
#include <leastcost/problems/section/is_surface.hpp>

namespace leastcost {

/// The surfaces of ParametricOptions, each with its measures in length units.
namespace parametric {

struct Plane {
  static constexpr std::string_view kType = "plane";
  static constexpr std::string_view kHelp = "(u, v, 0).";
};

struct Sphere {
  static constexpr std::string_view kType = "sphere";
  static constexpr std::string_view kHelp = "u: longitude, v: latitude.";
  double radius = 1;
  void fields(FieldVisitor& visit);
};

struct Ellipsoid {
  static constexpr std::string_view kType = "ellipsoid";
  static constexpr std::string_view kHelp =
      "u: longitude, v: reduced latitude (that of the unit sphere before stretching).";
  Eigen::VectorXd axes = Eigen::Vector3d(3, 2, 1);  ///< along x, y, z
  void fields(FieldVisitor& visit);
};

struct Torus {
  static constexpr std::string_view kType = "torus";
  static constexpr std::string_view kHelp = "u: around the axis, v: around the tube.";
  double major_radius = 2, minor_radius = 1;  ///< of the centre circle, and of the tube
  void fields(FieldVisitor& visit);
};

struct Cylinder {
  static constexpr std::string_view kType = "cylinder";
  static constexpr std::string_view kHelp = "u: around the axis, v: height.";
  double radius = 1;  ///< length units
  void fields(FieldVisitor& visit);
};

struct Cone {
  static constexpr std::string_view kType = "cone";
  static constexpr std::string_view kHelp = "u: around the axis, v: distance from the apex along a ruling.";
  double half_angle = 0.5;  ///< radians
  void fields(FieldVisitor& visit);
};

struct Catenoid {
  static constexpr std::string_view kType = "catenoid";
  static constexpr std::string_view kHelp = "u: around the axis, v: height.";
  double waist = 1;  ///< radius where it is narrowest
  void fields(FieldVisitor& visit);
};

struct Paraboloid {
  static constexpr std::string_view kType = "paraboloid";
  static constexpr std::string_view kHelp = "z = k r^2 / 2; u: around the axis, v: r.";
  double curvature = 1;  ///< z = curvature / 2 times the squared distance from the axis
  void fields(FieldVisitor& visit);
};

struct Hyperboloid {
  static constexpr std::string_view kType = "hyperboloid";
  static constexpr std::string_view kHelp = "(x^2 + y^2) / waist^2 - z^2 / height^2 = 1; u: around the axis, v: z.";
  double waist = 1, height = 1;  ///< radius where it is narrowest; how fast it rises
  void fields(FieldVisitor& visit);
};

struct KleinBottle {
  static constexpr std::string_view kType = "klein_bottle";
  static constexpr std::string_view kHelp = "VFCS Eq. (17), corrected; crossing u = 2 pi reverses the sign of v.";
  double major_radius = 2, minor_radius = 1;  ///< of the centre circle, and of the tube
  void fields(FieldVisitor& visit);
};

struct MoebiusStrip {
  static constexpr std::string_view kType = "moebius_strip";
  static constexpr std::string_view kHelp = "VFCS Eq. (18); crossing u = pi reverses the sign of v.";
  double half_width = 0.5;  ///< of the strip
  void fields(FieldVisitor& visit);
};

struct Spiral {
  static constexpr std::string_view kType = "spiral";
  static constexpr std::string_view kHelp = "Helicoid, VFCS Eq. (19): u along the rulings, v the angle.";
  double pitch = 1;
  void fields(FieldVisitor& visit);
};

struct Enneper {
  static constexpr std::string_view kType = "enneper";
  static constexpr std::string_view kHelp = "Enneper's minimal surface.";
};

struct Formula {
  static constexpr std::string_view kType = "formula";
  static constexpr std::string_view kHelp = "x, y, z as formulas in u and v.";
  std::string x = {}, y = {}, z = {};
  std::map<std::string, double> parameters = {};
  std::optional<double> period_u = {}, period_v = {};
  bool twisted = false;  ///< v changes sign where u comes back
  void fields(FieldVisitor& visit);
};

using Surface = std::variant<Plane, Sphere, Ellipsoid, Torus, Cylinder, Cone, Catenoid, Paraboloid, Hyperboloid,
                             KleinBottle, MoebiusStrip, Spiral, Enneper, Formula>;

}  // namespace parametric

/// A surface by name with its measures, or by formulas, and bounds on u and v.
struct ParametricOptions {
  parametric::Surface surface = {};
  BoxOptions box = {};  ///< bounds of the coordinates
  void fields(FieldVisitor& visit);
};

/// A surface x(u, v) in R^3 (VFCS 4.4.1, Eq. 12). The chart's coordinates are the unknowns; they lie on the universal
/// cover, so that paths cross seams and poles and keep their winding. The edges of the chart (an apex, a rim) are
/// bounds.
class ParametricManifold : public ConstraintManifold,
                           public HasChart,
                           public EnclosesChart,
                           public HasBounds,
                           public HasSeams,
                           public HasImages,
                           public IsSurface,
                           public DrawsItself {
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
  void embed_with_jacobians(const CoordinatePath& path, Points& x, Points& j) const override;
  void curvatures(const CoordinatePath& path, const Points& weights, Points& h) const override;
  void enclose_chart(std::span<const IntervalJet<2>, 2> u, std::span<IntervalJet<2>> x,
                     std::span<IntervalJet<2>> jacobian) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  const std::vector<Seam>& seams() const override { return seams_; }
  Eigen::Matrix2d edges() const override { return (Eigen::Matrix2d() << box_.lower(), box_.upper()).finished(); }
  const std::vector<SeamMap>& poles() const override { return poles_; }
  std::vector<PointImage> images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                 std::size_t most) const override;
  bool states_way(const Eigen::VectorXd& target, const Eigen::VectorXd& source) const override;
  Eigen::VectorXd nearest_name(const Eigen::VectorXd& x, const Eigen::VectorXd& reference) const override;
  std::vector<std::string> coordinate_names() const override { return {"u", "v"}; }
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 private:
  /// Every loop on a closed surface with two poles slips off over one of them: there are no windings.
  bool is_sphere_like() const { return poles_.size() == 2; }

  std::shared_ptr<const ChartMap> map_;
  Box box_;
  std::vector<Seam> seams_;
  std::vector<SeamMap> poles_;
};

/// Throws OptionError.
std::shared_ptr<const ParametricManifold> make_parametric_manifold(const ParametricOptions& options);

}  // namespace leastcost
