// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The named surfaces of the parametric manifold: their options, charts, edges and seams.
#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "problems/formula/formula.hpp"
#include "problems/manifolds/chart_surfaces.hpp"

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
      throw OptionError(key, "the formulas do not come back after this period" +
                                 std::string(seams[s].flipped ? " with v turned over" : "") + ": (u, v) = (" +
                                 std::to_string(u[0]) + ", " + std::to_string(u[1]) + ") and its image are " +
                                 std::to_string((x - y).norm()) + " apart");
    }
  }
}

Parts formula(const ParametricOptions& o) {
  std::vector<Seam> seams;
  if (o.period_u > 0) seams.push_back({0, o.period_u, o.twisted ? std::optional(1) : std::nullopt});
  if (o.period_v > 0) seams.push_back({1, o.period_v, {}});
  if (o.twisted && !(o.period_u > 0))
    throw OptionError("surface.twisted", "turns v over where u comes back: it needs period_u");
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

Parts parts_of(const ParametricOptions& o) {
  const std::string& type = o.type;
  if (type == "plane") return {make_chart_map(chart::Plane{})};
  if (type == "sphere") return {make_chart_map(chart::Ellipsoid{o.radius, o.radius, o.radius}), {kAround}, kTwoPoles};
  if (type == "ellipsoid")
    return {make_chart_map(chart::Ellipsoid{o.axes[0], o.axes[1], o.axes[2]}), {kAround}, kTwoPoles};
  if (type == "torus")
    return {make_chart_map(chart::Torus{o.major_radius, o.minor_radius}), {kAround, {1, 2 * kPi, {}}}};
  if (type == "cylinder") return {make_chart_map(chart::Cylinder{o.radius}), {kAround}};
  if (type == "cone") return {make_chart_map(chart::Cone{o.half_angle}), {kAround}, {}, 0};
  if (type == "catenoid") return {make_chart_map(chart::Catenoid{o.waist}), {kAround}};
  if (type == "paraboloid") return {make_chart_map(chart::Paraboloid{o.curvature}), {kAround}, {pole(0)}};
  if (type == "hyperboloid") return {make_chart_map(chart::Hyperboloid{o.waist, o.height}), {kAround}};
  if (type == "klein_bottle")
    return {make_chart_map(chart::KleinBottle{o.major_radius, o.minor_radius}), {{0, 2 * kPi, 1}, {1, 2 * kPi, {}}}};
  if (type == "moebius_strip")
    return {make_chart_map(chart::MoebiusStrip{}), {{0, kPi, 1}}, {}, -o.half_width, o.half_width};
  if (type == "spiral") return {make_chart_map(chart::Spiral{o.pitch})};
  if (type == "enneper") return {make_chart_map(chart::Enneper{})};
  if (type == "formula") return formula(o);
  throw OptionError("surface.type", "unknown surface '" + type + "'");
}

/// The chart's own edges, and what the options add to them.
Box box_of(const ParametricOptions& o, const Parts& parts) {
  Box given(2, o.box);
  const bool edges = parts.v_least > -kUnbounded || parts.v_most < kUnbounded;
  if (!edges) return given;
  BoxOptions both{given.lower(), given.upper()};
  both.lower[1] = std::max(both.lower[1], parts.v_least);
  both.upper[1] = std::min(both.upper[1], parts.v_most);
  return Box(2, both);
}

}  // namespace

void ParametricOptions::fields(FieldVisitor& visit) {
  const auto length = [](FieldVisitor& v, const char* key, double& value, const char* help) {
    v.field(key, value, {.help = help, .unit = "length", .minimum = 0, .exclusive_minimum = true});
  };
  const auto round = [&](const char* help) {
    return [&, help](FieldVisitor& v) { length(v, "radius", radius, help); };
  };
  const auto tube = [&](FieldVisitor& v) {
    length(v, "major_radius", major_radius, "From the axis to the middle of the tube (a of VFCS Eq. 17).");
    length(v, "minor_radius", minor_radius, "Of the tube (b of VFCS Eq. 17).");
  };
  visit.variant(
      "surface", type,
      {{"plane", "(u, v, 0)."},
       {"sphere", "u: longitude, v: latitude.", round("Radius.")},
       {"ellipsoid", "u: longitude, v: latitude on the unit sphere that is stretched (reduced latitude).",
        [&](FieldVisitor& v) {
          v.field("axes", axes,
                  {.help = "Half axes along x, y, z.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
        }},
       {"torus", "u: around the axis, v: around the tube.", tube},
       {"cylinder", "u: around the axis, v: height.", round("Radius.")},
       {"cone", "u: around the axis, v: distance from the apex along a ruling.",
        [&](FieldVisitor& v) {
          v.field("half_angle", half_angle,
                  {.help = "Between axis and ruling.",
                   .unit = "radians",
                   .minimum = 0,
                   .maximum = kPi / 2,
                   .exclusive_minimum = true});
        }},
       {"catenoid", "u: around the axis, v: height.",
        [&](FieldVisitor& v) { length(v, "waist", waist, "Least distance from the axis."); }},
       {"paraboloid", "z = k r^2 / 2; u: around the axis, v: r.",
        [&](FieldVisitor& v) { v.field("curvature", curvature, {.help = "k.", .unit = "1/length"}); }},
       {"hyperboloid", "(x^2 + y^2) / waist^2 - z^2 / height^2 = 1; u: around the axis, v: z.",
        [&](FieldVisitor& v) {
          length(v, "waist", waist, "Least distance from the axis.");
          length(v, "height", height, "Height at which the radius has grown by sqrt(2).");
        }},
       {"klein_bottle", "VFCS Eq. (17), mended; crossing u = 2 pi turns v over.", tube},
       {"moebius_strip", "VFCS Eq. (18); crossing u = pi turns v over.",
        [&](FieldVisitor& v) { length(v, "half_width", half_width, "The strip is -half_width <= v <= half_width."); }},
       {"spiral", "Helicoid, VFCS Eq. (19): u along the rulings, v the angle.",
        [&](FieldVisitor& v) { v.field("pitch", pitch, {.help = "a of z = a v.", .unit = "length"}); }},
       {"enneper", "Enneper's minimal surface."},
       {"formula", "x, y, z as formulas in u and v.",
        [&](FieldVisitor& v) {
          v.field("x", x, {.help = "x(u, v), like (2 + cos(v)) * cos(u).", .required = true});
          v.field("y", y, {.help = "y(u, v).", .required = true});
          v.field("z", z, {.help = "z(u, v).", .required = true});
          v.field("parameters", parameters, {.help = "Numbers that the formulas may name, like {a: 2, b: 1}."});
          v.field("period_u", period_u, {.help = "Period of u; 0: not periodic.", .minimum = 0});
          v.field("period_v", period_v, {.help = "Period of v; 0: not periodic.", .minimum = 0});
          v.field("twisted", twisted,
                  {.help = "Whether v changes sign where u comes back (Moebius strip, Klein bottle)."});
        }}},
      {.help = "The surface: a name with its measures, or formulas in u and v.", .required = true});
  box.fields(visit);
}

std::shared_ptr<const ParametricManifold> make_parametric_manifold(const ParametricOptions& options) {
  if (options.type == "ellipsoid" && (options.axes.size() != 3 || !(options.axes.array() > 0).all()))
    throw OptionError("surface.axes", "an ellipsoid has three positive half axes");
  Parts parts = parts_of(options);
  Box box = box_of(options, parts);
  return std::make_shared<ParametricManifold>(std::move(parts.map), std::move(box), std::move(parts.seams),
                                              std::move(parts.poles));
}

}  // namespace leastcost
