// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/framework/path/path.hpp>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// A way between two points that pays only before and after a free place.
struct FreePassage {
  Points points;    ///< ambient; at equal shares of the cost, but for the two on the free place
  Index free = 0;   ///< the segment that costs nothing
  double cost = 0;  ///< of the curve
};

/// Ability of a cost under which moves cost nothing in some places (n = y^k with k > 0, on y = 0): the cheapest way by
/// such a place rivals every path that keeps away from them (Goldschmidt's solution beside the catenary), and a path
/// that comes to one has become that way: it has collapsed.
class HasFreePlaces {
 public:
  virtual ~HasFreePlaces() = default;
  /// Of a cost that may have them.
  virtual bool present() const = 0;
  /// Distance of a place from them.
  virtual double distance_to_free(const Eigen::VectorXd& x) const = 0;
  /// The cheapest way by them, in so many segments, three at least.
  virtual FreePassage free_passage(const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                                   Index segments) const = 0;
};

}  // namespace leastcost
