// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The named surfaces of the parametric manifold: their options, charts, edges and seams.
#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "framework/base/point_text.hpp"
#include "problems/formula/formula.hpp"
#include "problems/manifolds/chart_surfaces.hpp"
#include "problems/manifolds/length_field.hpp"

namespace leastcost {
namespace {

constexpr double kPi = std::numbers::pi, kUnbounded = std::numeric_limits<double>::infinity();

/// (x, y, z)(u, v) from three formulas.
struct FormulaChart {
  Formulas xyz;
  template <class S>
  Eigen::Matrix<S, 3, 1> operator()(const S& u, const S& v) const {
    const std::array<S, 2> uv = {u, v};
    Eigen::Matrix<S, 3, 1> x;
    xyz.evaluate<S>(uv, {x.data(), 3});
    return x;
  }
};

struct Parts {
  std::shared_ptr<const ChartMap> map;
  std::vector<Seam> seams = {};
  std::vector<SeamMap> poles = {};
  double v_least = -kUnbounded, v_most = kUnbounded;  ///< edges of the chart in v
};

const Seam kAround = {0, 2 * kPi, {}};

/// v goes on beyond a pole at v = `at`, on the other side of it.
SeamMap pole(double at) { return {Eigen::Vector2d(1, -1), Eigen::Vector2d(kPi, 2 * at)}; }
const std::vector<SeamMap> kTwoPoles = {pole(kPi / 2), pole(-kPi / 2)};

/// Where formulas are looked at before they are used.
const std::array<Eigen::Vector2d, 3> kSamples = {Eigen::Vector2d(0.3, 0.2), Eigen::Vector2d(1.1, -0.7),
                                                 Eigen::Vector2d(2.3, 0.9)};

/// Formulas of one combination of u and v only describe a curve or a point, on which the coordinates of a path mean
/// nothing.
void check_rank(const ChartMap& map) {
  constexpr double kParallel = 1e-9;
  bool looked = false;
  for (const Eigen::Vector2d& u : kSamples) {
    const Eigen::Matrix<double, 3, 2> j = map.jacobian(u);
    if (!j.allFinite()) continue;
    looked = true;
    if (j.col(0).cross(j.col(1)).norm() > kParallel * j.col(0).norm() * j.col(1).norm()) return;
  }
  if (looked)
    throw OptionError("surface",
                      "x, y and z do not describe a surface: moves along u and along v have the same direction");
}

/// The formulas must mean what the periods say: an image of a point is the same point.
void check_seams(const ChartMap& map, const std::vector<Seam>& seams) {
  constexpr double kSame = 1e-9;
  for (std::size_t s = 0; s < seams.size(); ++s) {
    Eigen::VectorXi once = Eigen::VectorXi::Zero(static_cast<Index>(seams.size()));
    once[static_cast<Index>(s)] = 1;
    const SeamMap image = seam_map(seams, 2, once);
    for (const Eigen::Vector2d& u : kSamples) {
      const Eigen::Vector3d x = map.position(u), y = map.position(image.apply(u));
      if (!x.allFinite() || !y.allFinite() || (x - y).norm() <= kSame * (1 + x.norm())) continue;
      const char* key = seams[s].coordinate == 0 ? "surface.period_u" : "surface.period_v";
      throw OptionError(key, "the formulas do not repeat after this period" +
                                 std::string(seams[s].flipped ? " with the sign of v reversed" : "") + ": (u, v) = " +
                                 point_text(u) + " and its image are " + short_number((x - y).norm()) + " apart");
    }
  }
}

Parts parts_of(const parametric::Formula& o) {
  if (o.period_u && !(*o.period_u > 0)) throw OptionError("surface.period_u", "must be greater than 0");
  if (o.period_v && !(*o.period_v > 0)) throw OptionError("surface.period_v", "must be greater than 0");
  std::vector<Seam> seams;
  if (o.period_u) seams.push_back({0, *o.period_u, o.twisted ? std::optional(1) : std::nullopt});
  if (o.period_v) seams.push_back({1, *o.period_v, {}});
  if (o.twisted && !o.period_u)
    throw OptionError("surface.twisted", "needs period_u: v changes sign after a period of u");
  const auto read = [&o](const char* key, const std::string& text) {  // each alone first: the error names its key
    formulas_of_option(std::string("surface.") + key, {text}, {"u", "v"}, o.parameters);
  };
  read("x", o.x);
  read("y", o.y);
  read("z", o.z);
  auto map = make_chart_map(FormulaChart{Formulas({o.x, o.y, o.z}, {"u", "v"}, o.parameters)});
  check_rank(*map);
  check_seams(*map, seams);
  return {std::move(map), seams};
}

Parts parts_of(const parametric::Plane&) { return {make_chart_map(chart::Plane{})}; }
Parts parts_of(const parametric::Sphere& o) {
  return {make_chart_map(chart::Ellipsoid{o.radius, o.radius, o.radius}), {kAround}, kTwoPoles};
}
Parts parts_of(const parametric::Ellipsoid& o) {
  if (o.axes.size() != 3 || !(o.axes.array() > 0).all())
    throw OptionError("surface.axes", "must be three positive semi-axes");
  return {make_chart_map(chart::Ellipsoid{o.axes[0], o.axes[1], o.axes[2]}), {kAround}, kTwoPoles};
}
Parts parts_of(const parametric::Torus& o) {
  return {make_chart_map(chart::Torus{o.major_radius, o.minor_radius}), {kAround, {1, 2 * kPi, {}}}};
}
Parts parts_of(const parametric::Cylinder& o) { return {make_chart_map(chart::Cylinder{o.radius}), {kAround}}; }
Parts parts_of(const parametric::Cone& o) { return {make_chart_map(chart::Cone{o.half_angle}), {kAround}, {}, 0}; }
Parts parts_of(const parametric::Catenoid& o) { return {make_chart_map(chart::Catenoid{o.waist}), {kAround}}; }
Parts parts_of(const parametric::Paraboloid& o) {
  return {make_chart_map(chart::Paraboloid{o.curvature}), {kAround}, {pole(0)}};
}
Parts parts_of(const parametric::Hyperboloid& o) {
  return {make_chart_map(chart::Hyperboloid{o.waist, o.height}), {kAround}};
}
Parts parts_of(const parametric::KleinBottle& o) {
  return {make_chart_map(chart::KleinBottle{o.major_radius, o.minor_radius}), {{0, 2 * kPi, 1}, {1, 2 * kPi, {}}}};
}
Parts parts_of(const parametric::MoebiusStrip& o) {
  return {make_chart_map(chart::MoebiusStrip{}), {{0, kPi, 1}}, {}, -o.half_width, o.half_width};
}
Parts parts_of(const parametric::Spiral& o) { return {make_chart_map(chart::Spiral{o.pitch})}; }
Parts parts_of(const parametric::Enneper&) { return {make_chart_map(chart::Enneper{})}; }

/// The chart's own edges, and what the options add to them.
Box box_of(const ParametricOptions& o, const Parts& parts) {
  Box given(2, o.box);
  const bool edges = parts.v_least > -kUnbounded || parts.v_most < kUnbounded;
  if (!edges) return given;
  Eigen::VectorXd lower = given.lower(), upper = given.upper();
  lower[1] = std::max(lower[1], parts.v_least);
  upper[1] = std::min(upper[1], parts.v_most);
  return Box(2, {lower, upper});
}

void tube(FieldVisitor& visit, double& major_radius, double& minor_radius) {
  length_field(visit, "major_radius", major_radius,
               "Distance from the axis to the centre of the tube (a of VFCS Eq. 17).");
  length_field(visit, "minor_radius", minor_radius, "Radius of the tube (b of VFCS Eq. 17).");
}

}  // namespace

namespace parametric {

void Sphere::fields(FieldVisitor& visit) { length_field(visit, "radius", radius, "Radius."); }
void Ellipsoid::fields(FieldVisitor& visit) {
  visit.field("axes", axes,
              {.help = "Semi-axes along x, y, z.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
}
void Torus::fields(FieldVisitor& visit) { tube(visit, major_radius, minor_radius); }
void Cylinder::fields(FieldVisitor& visit) { length_field(visit, "radius", radius, "Radius."); }
void Cone::fields(FieldVisitor& visit) {
  visit.field("half_angle", half_angle,
              {.help = "Angle between the axis and a ruling.",
               .unit = "radians",
               .minimum = 0,
               .maximum = kPi / 2,
               .exclusive_minimum = true});
}
void Catenoid::fields(FieldVisitor& visit) { length_field(visit, "waist", waist, "Least distance from the axis."); }
void Paraboloid::fields(FieldVisitor& visit) {
  visit.field("curvature", curvature, {.help = "k.", .unit = "1/length"});
}
void Hyperboloid::fields(FieldVisitor& visit) {
  length_field(visit, "waist", waist, "Least distance from the axis.");
  length_field(visit, "height", height, "Height at which the radius has grown by sqrt(2).");
}
void KleinBottle::fields(FieldVisitor& visit) { tube(visit, major_radius, minor_radius); }
void MoebiusStrip::fields(FieldVisitor& visit) {
  length_field(visit, "half_width", half_width, "The strip is -half_width <= v <= half_width.");
}
void Spiral::fields(FieldVisitor& visit) {
  visit.field("pitch", pitch, {.help = "The constant a in z = a v.", .unit = "length"});
}
void Formula::fields(FieldVisitor& visit) {
  visit.field("x", x, {.help = "x(u, v), like (2 + cos(v)) * cos(u).", .required = true});
  visit.field("y", y, {.help = "y(u, v).", .required = true});
  visit.field("z", z, {.help = "z(u, v).", .required = true});
  visit.field("parameters", parameters, {.help = "Constants that the formulas can use, like {a: 2, b: 1}."});
  visit.field_or_zero("period_u", period_u, {.help = "Period of u; 0: not periodic.", .minimum = 0});
  visit.field_or_zero("period_v", period_v, {.help = "Period of v; 0: not periodic.", .minimum = 0});
  visit.field("twisted", twisted,
              {.help = "Whether v changes sign when u completes a period (Moebius strip, Klein bottle)."});
}

}  // namespace parametric

void ParametricOptions::fields(FieldVisitor& visit) {
  visit.variant("surface", surface,
                {.help = "The surface: a named one with its dimensions, or formulas in u and v.", .required = true});
  box.fields(visit);
}

std::shared_ptr<const ParametricManifold> make_parametric_manifold(const ParametricOptions& options) {
  Parts parts = std::visit([](const auto& surface) { return parts_of(surface); }, options.surface);
  Box box = box_of(options, parts);
  return std::make_shared<ParametricManifold>(std::move(parts.map), std::move(box), std::move(parts.seams),
                                              std::move(parts.poles));
}

}  // namespace leastcost
