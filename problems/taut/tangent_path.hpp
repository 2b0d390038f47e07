// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/path/path.hpp>
#include "problems/taut/string_pull.hpp"
#include "problems/taut/tangent.hpp"

namespace leastcost {

/// A path in the plane that cannot be shortened: straight from disc to disc, tangent to both, and along their circles.
/// Free space there is flat with holes, so this is the shortest path of its class, and the only one that is locally
/// shortest (its universal cover has no positive curvature).
class TangentPath {
 public:
  /// From the bends of a string pulled tight: those that would be bent the wrong way are left out, and discs that the
  /// path comes into are added, until neither is needed. Nothing where that does not come to an end. Throws
  /// Interrupted.
  static std::optional<TangentPath> make(const Walls& walls, const Eigen::Vector2d& source,
                                         const Eigen::Vector2d& target, std::vector<Bend> bends,
                                         const Deadline& deadline);

  double length() const;
  const std::vector<Bend>& bends() const { return bends_; }
  /// As a polyline that touches each circle from outside and is longer by at most `excess`, relative: 2 x m.
  Points polyline(double excess) const;

 private:
  class Maker;

  std::vector<Bend> bends_;
  std::vector<Tangent> legs_;  ///< one more than bends; the straight parts
};

}  // namespace leastcost
