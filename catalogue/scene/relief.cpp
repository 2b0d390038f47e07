// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/scene/relief.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/domain/has_box.hpp>
#include "problems/drawing/surroundings.hpp"

namespace leastcost {
namespace {

constexpr int kReliefCells = 160;  ///< cells
constexpr double kAround = 0.25;
constexpr double kNone = std::numeric_limits<double>::infinity();

/// The part of the map that is shown: the paths with what is around them, within the domain.
Surroundings map_around(const ConstraintManifold& domain, const Points& paths) {
  Surroundings shown = around(paths.topRows(2)).enlarged(kAround);
  const double least = 0.5 * shown.extent().maxCoeff();  // a path along an axis gets some height, too
  for (Index i = 0; i < 2; ++i) {
    const double missing = std::max(0.0, least - shown.extent()[i]) / 2;
    shown.lower[i] -= missing;
    shown.upper[i] += missing;
  }
  if (const auto* box = find_ability<HasBox>(domain)) {
    shown.lower = shown.lower.cwiseMax(box->box_lower());
    shown.upper = shown.upper.cwiseMin(box->box_upper());
  }
  return shown;
}

/// Heights at the nodes of a raster and at one more on each side; NaN where there is no ground.
Points heights_of(const ConstraintManifold& domain, const Raster& raster, const Eigen::Vector2d& cell) {
  CoordinatePath nodes;
  nodes.u.resize(2, static_cast<Index>(raster.columns + 2) * (raster.rows + 2));
  Index k = 0;
  for (int j = -1; j <= raster.rows; ++j)
    for (int i = -1; i <= raster.columns; ++i)
      nodes.u.col(k++) = raster.lower + cell.cwiseProduct(Eigen::Vector2d(i, j));
  const Points x = positions(domain, nodes);
  for (k = 0; k < x.cols(); ++k)
    if (x.col(k).allFinite() && x.col(k).head<2>() != nodes.u.col(k)) return {};
  return x.row(2).reshaped(raster.columns + 2, raster.rows + 2);
}

double lightness(double slope_x, double slope_y) {
  const Eigen::Vector3d sun = Eigen::Vector3d(-1, 1, std::sqrt(2.0)).normalized();
  return std::max(0.0, Eigen::Vector3d(-slope_x, -slope_y, 1).normalized().dot(sun));
}

}  // namespace

std::optional<Raster> relief_around(const ConstraintManifold& domain, const Points& paths) {
  constexpr double kEven = 1e-3;
  const Dimensions dimensions = domain.dimensions();
  if (find_ability<HasChart>(domain) == nullptr || dimensions.coordinate != 2 || dimensions.ambient != 3) return {};
  const Surroundings shown = map_around(domain, paths);
  if (!(shown.extent().minCoeff() > 0)) return {};
  const Eigen::Vector2d count = (shown.extent() / shown.extent().maxCoeff() * kReliefCells).array().round().max(8);
  const Eigen::Vector2d cell = shown.extent().cwiseQuotient(count);
  Raster out{static_cast<int>(count[0]) + 1, static_cast<int>(count[1]) + 1, shown.lower, shown.upper, {}};
  const Points z = heights_of(domain, out, cell);
  if (z.size() == 0) return {};
  double least = kNone, largest = 0;
  for (Index j = 1; j <= out.rows; ++j)
    for (Index i = 1; i <= out.columns; ++i) {
      // One-sided at a border of the ground, whose outer neighbours are not known.
      const auto slope = [&](Index a, Index b, double side) {
        const double up = (z(i + a, j + b) - z(i, j)) / side, down = (z(i, j) - z(i - a, j - b)) / side;
        return !std::isfinite(up) ? down : !std::isfinite(down) ? up : (up + down) / 2;
      };
      const double light = lightness(slope(1, 0, cell[0]), slope(0, 1, cell[1]));
      out.values.push_back(std::isfinite(z(i, j)) && std::isfinite(light) ? light : kNone);
      if (!std::isfinite(out.values.back())) continue;
      least = std::min(least, light);
      largest = std::max(largest, light);
    }
  if (!(largest > least + kEven)) return {};
  return out;
}

}  // namespace leastcost
