// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/plane_on_earth.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>

namespace leastcost {

void refuse_plane_on_earth(const Obstacle& obstacle, const ConstraintManifold& domain, const std::string& key) {
  constexpr double kRoom = 1.01;  // for sides that bulge between their corners
  if (obstacle.core_bounds().dim() == domain.dimensions().ambient) return;
  const Eigen::MatrixXd corners = obstacle.corners();
  if (find_ability<HasChart>(domain) == nullptr || find_ability<IsGeographic>(domain) == nullptr ||
      corners.rows() != 2 || corners.cols() == 0)
    return;
  const Points x = positions(domain, {corners, {}, true});
  const Eigen::VectorXd middle = x.rowwise().mean();
  const double radius = kRoom * (x.colwise() - middle).colwise().norm().maxCoeff();
  throw OptionError(
      key,
      fmt::format(
          "{} has 2 dimensions, but obstacles on the Earth are in space, in metres from its centre. If its corners are "
          "latitudes and longitudes, this ball contains them: {{type: ball, center: [{:.0f}], radius: {:.0f}}}",
          obstacle.name(), fmt::join(middle, ", "), std::ceil(radius)));
}

}  // namespace leastcost
