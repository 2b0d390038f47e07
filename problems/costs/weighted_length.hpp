// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

struct WeightedLengthOptions {
  Eigen::VectorXd weights = {};  ///< one per factor of the domain, or one per coordinate; each greater than 0
  void fields(FieldVisitor& visit);
};

/// c(a, b) = sqrt(sum_k (w_k |b_k - a_k|)^2), the length of a move in which every factor of the domain counts w_k.
///
/// Given per factor (HasBlocks), a weight is in length per unit of that factor: 1 for a place, for an angle or a
/// rotation in length per radian, the distance from the origin of the body, say, at which it is as dear to turn as to
/// move. A rotation given by a unit quaternion is measured by twice the chord, which is its angle phi to second order,
/// 4 sin(phi / 4): a path along the rotations costs w phi in the limit. Between poses the least-cost path is a straight
/// line with a constant turn, of cost sqrt(L^2 + (w phi)^2).
///
/// Given per coordinate the weights are those of coordinates as they are: of chords for a quaternion.
///
/// Throws OptionError.
std::shared_ptr<const ConstantMetricCost> make_weighted_length(const WeightedLengthOptions& options,
                                                               const ConstraintManifold& domain);

}  // namespace leastcost
