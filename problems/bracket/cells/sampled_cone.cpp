// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/sampled_cone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/bracket/cells/sampled_norms.hpp"

namespace leastcost::bracket {

using Eigen::Vector2d;

double SampledCone::middle_cost(const Vector2d& d) const {
  if (d.isZero(0)) return 0;
  const Vector2d middle = (end + 0.5 * d).cwiseMax(box.min()).cwiseMin(box.max());
  return CoordinateCost::Element(*cost, middle)(reversed ? Vector2d(-d) : d);
}

std::optional<SampledCone> sampled_cone(const CoordinateCost& cost, const Eigen::AlignedBox2d& box, const Vector2d& end,
                                        double reach, bool reversed) {
  constexpr int kRadii = 6, kDirections = 48;
  constexpr double kBeyond = 2, kShort = 1e-4, kHopeless = 20;
  SampledCone cone{&cost, box, end, reversed, 1, std::numeric_limits<double>::infinity()};
  double steepest = 1;
  const double step = kShort * reach;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
    const Vector2d e(std::cos(angle), std::sin(angle));
    for (int i = 1; i <= kRadii; ++i) {
      const Vector2d d = kBeyond * reach * i / kRadii * e, x = end + d;
      if (!box.contains(x)) continue;
      const auto slope = [&](const Vector2d& along) {
        return (cone.middle_cost(d + step * along) - cone.middle_cost(d - step * along)) / (2 * step);
      };
      const Vector2d p(slope(Vector2d::UnitX()), slope(Vector2d::UnitY()));
      if (!p.allFinite()) return std::nullopt;
      const Vector2d moved = reversed ? Vector2d(-p) : p;
      steepest = std::max(steepest, dual_norm({cost, x}, moved, std::atan2(moved[1], moved[0])));
      if (i == kRadii) cone.most = std::min(cone.most, cone.middle_cost(d));
    }
  }
  if (!(steepest < kHopeless)) return std::nullopt;
  cone.factor = 1 / steepest;
  cone.most *= cone.factor;
  return cone;
}

}  // namespace leastcost::bracket
