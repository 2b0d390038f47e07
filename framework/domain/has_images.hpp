// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Other coordinates of the same point.
struct PointImage {
  Eigen::VectorXd u;     ///< the coordinates that name the same point
  std::string where;     ///< in words: "winding (1, 0)", "winding (0) over pole 1", "-q"
  std::string way = {};  ///< "over the north pole", where coordinates would only puzzle (a latitude of 232); else empty
};

/// Ability: several coordinates name one point of the domain (across the seams and over the poles of a chart, the two
/// quaternions of a rotation).
class HasImages {
 public:
  virtual ~HasImages() = default;
  /// The images of x other than x itself that are nearest to `reference` in coordinates, nearest first, at most `most`
  /// of them.
  virtual std::vector<PointImage> images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                         std::size_t most) const = 0;
  /// Whether the coordinates of a target mean a way as well, a winding say, and not only the point: those of a chart
  /// that are a period or more away from `source` do.
  virtual bool states_way(const Eigen::VectorXd& target, const Eigen::VectorXd& source) const = 0;
  /// Where a coordinate is a name and never a winding (the longitude of a sphere): x with the one nearest to
  /// `reference`. Elsewhere x itself.
  virtual Eigen::VectorXd nearest_name(const Eigen::VectorXd& x, const Eigen::VectorXd& reference) const {
    static_cast<void>(reference);
    return x;
  }
};

}  // namespace leastcost
