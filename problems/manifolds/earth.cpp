// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/earth.hpp>

#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include "problems/manifolds/chart_surfaces.hpp"

namespace leastcost {
namespace {

/// f of a checked ellipsoid.
double flattening_of(const EarthOptions& o) {
  if (!(o.semi_major_axis > 0) || !std::isfinite(o.semi_major_axis))
    throw OptionError("semi_major_axis", "must be a length greater than 0, in metres");
  if (o.inverse_flattening == 0) return 0;
  if (!(o.inverse_flattening > 1))  // f < 1: at f = 1 the poles meet
    throw OptionError("inverse_flattening", "must be greater than 1 (298.257223563 for WGS84), or 0 for a sphere");
  return 1 / o.inverse_flattening;
}

/// Latitude goes on beyond the pole at `at` on the meridian opposite.
SeamMap over_pole(double at) { return {Eigen::Vector2d(-1, 1), Eigen::Vector2d(2 * at, 180)}; }

}  // namespace

void EarthOptions::fields(FieldVisitor& visit) {
  visit.field("semi_major_axis", semi_major_axis,
              {.help = "Equatorial radius of the ellipsoid; default: WGS84.",
               .unit = "m",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field("inverse_flattening", inverse_flattening,
              {.help = "1 / f of the ellipsoid; 0: a sphere; default: WGS84.", .minimum = 0});
}

EarthManifold::EarthManifold(const EarthOptions& options)
    : ParametricManifold(make_chart_map(chart::Geodetic{options.semi_major_axis, flattening_of(options)}), Box(2),
                         {{1, 360, {}}}, {over_pole(90), over_pole(-90)}) {}

std::vector<PointImage> EarthManifold::images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                              std::size_t most) const {
  std::vector<PointImage> all = ParametricManifold::images(x, reference, most);
  for (PointImage& image : all)
    image.way = std::abs(image.u[0]) <= 90 ? "the other way round"
                                           : (image.u[0] > 0 ? "over the north pole" : "over the south pole");
  return all;
}

}  // namespace leastcost
