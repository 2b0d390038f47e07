// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// The indices n(x) of RefractiveIndexOptions.
namespace refraction {

/// n = 1 / (speed + gradient . x): arcs of circles. Outside: where the speed is not positive.
struct LinearVelocity {
  static constexpr std::string_view kType = "linear_velocity";
  static constexpr std::string_view kHelp = "n = 1 / v, v = speed + gradient . x: rays are arcs of circles.";
  double speed = 1;               ///< at the origin
  Eigen::VectorXd gradient = {};  ///< one number per coordinate
  void fields(FieldVisitor& visit);
};

/// n = sqrt(2 - r^2), r = |x - center| / radius, for r < sqrt 2: arcs of ellipses.
struct Luneburg {
  static constexpr std::string_view kType = "luneburg";
  static constexpr std::string_view kHelp =
      "n = sqrt(2 - r^2), r = |x - center| / radius < sqrt 2: rays are arcs of ellipses.";
  double radius = 1;
  Eigen::VectorXd center = {};  ///< empty: the origin
  void fields(FieldVisitor& visit);
};

/// n = peak / (1 + r^2), r = |x - center| / radius: arcs of circles, and every point has an image. Maxwell 1854.
struct MaxwellFisheye {
  static constexpr std::string_view kType = "maxwell_fisheye";
  static constexpr std::string_view kHelp =
      "n = peak / (1 + r^2), r = |x - center| / radius: rays are arcs of circles.";
  double peak = 2;
  double radius = 1;
  Eigen::VectorXd center = {};  ///< empty: the origin
  void fields(FieldVisitor& visit);
};

/// What the values of layers are: indices, or speeds 1 / n.
enum class LayerValues { index, speed };
Words<LayerValues> words(LayerValues);

/// Layers across a normal, each boundary a step (1 + tanh(d / width)) / 2 of the distance d beyond it.
struct SmoothLayers {
  static constexpr std::string_view kType = "smooth_layers";
  static constexpr std::string_view kHelp = "Layers with smooth steps at their boundaries.";
  Eigen::VectorXd boundaries = {};  ///< places along the normal, increasing, length units
  Eigen::VectorXd values = {};      ///< one more
  LayerValues values_are = LayerValues::index;
  double width = 0;             ///< of a step, length units
  Eigen::VectorXd normal = {};  ///< empty: along the last coordinate; else scaled to length 1
  void fields(FieldVisitor& visit);
};

/// n = (y - level)^exponent with the last coordinate y: half-plane (-1), cycloids (-1/2), lines (0), parabolas (1/2),
/// catenaries (1).
struct PowerLaw {
  static constexpr std::string_view kType = "power_law";
  static constexpr std::string_view kHelp =
      "n = (y - level)^exponent with the last coordinate y: half-plane -1, parabola 1/2, catenary 1.";
  double exponent = 0;
  double level = 0;
  void fields(FieldVisitor& visit);
};

struct Formula {
  static constexpr std::string_view kType = "formula";
  static constexpr std::string_view kHelp = "n as a formula in the coordinates.";
  std::string n = {};
  std::map<std::string, double> parameters = {};
  void fields(FieldVisitor& visit);
};

using Index = std::variant<LinearVelocity, Luneburg, MaxwellFisheye, SmoothLayers, PowerLaw, Formula>;

}  // namespace refraction

struct RefractiveIndexOptions {
  refraction::Index index = {};
  void fields(FieldVisitor& visit);
};

/// Optical length, the integral of n(x) |dx|: c(a, b) = n(m) |b - a| with n in the middle m of the segment, exact for
/// an n that is linear along it. Symmetric; the metric n^2 I (EnclosesMetric, HasConformalMetric: certificates can be
/// proved). +infinity where an end or the middle has no positive n, and the cost says where (ExplainsInfinity); 0 is
/// allowed where n = y^k vanishes. In any dimension. Throws OptionError.
std::shared_ptr<const SegmentCost> make_refractive_index_cost(const RefractiveIndexOptions& options, int dim);

}  // namespace leastcost
