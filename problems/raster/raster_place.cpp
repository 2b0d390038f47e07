// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>

#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

Eigen::Vector2d RasterGrid::longitude_latitude(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d in_file = degrees ? degrees->corner + place.cwiseQuotient(degrees->per_degree) : place;
  return crs && crs->to_wgs84 ? crs->to_wgs84(in_file) : in_file;
}

Eigen::Vector2d RasterGrid::place_of(const Eigen::Vector2d& longitude_latitude) const {
  Eigen::Vector2d in_file = crs && crs->from_wgs84 ? crs->from_wgs84(longitude_latitude) : longitude_latitude;
  if (!degrees) return in_file;
  const double middle = degrees->corner[0] + 0.5 * columns * cell[0] / degrees->per_degree[0];
  in_file[0] += 360 * std::round((middle - in_file[0]) / 360);
  return degrees->per_degree.cwiseProduct(in_file - degrees->corner);
}

std::string RasterGrid::place_note() const {
  if (!degrees) return "";
  std::array<char, 96> at{};
  std::snprintf(at.data(), at.size(), "longitude %.9g and latitude %.9g", degrees->corner[0], degrees->corner[1]);
  const std::string why =
      crs ? source + " is in degrees" + (crs->name.empty() ? "" : " (" + crs->name + ")") + ": " : "";
  return why + "points are in metres east and north of " + at.data() +
         ", on a plane that is exact at the centre; ends can be given as {lonlat: [longitude, latitude]}";
}

}  // namespace leastcost
