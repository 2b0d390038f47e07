// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// A box in coordinates, sides of which may be infinite.
struct SampleBox {
  Eigen::VectorXd lower, upper;  ///< corners, coordinate
};

/// Ability of a domain: it knows where random samples of its coordinates are of use to a search for a path between two
/// points. What lies beyond is another name of a point within (a turn on), or no point at all (off a sphere).
class HasSampleBox {
 public:
  virtual ~HasSampleBox() = default;
  /// Where random points between these two are drawn from.
  virtual SampleBox sample_box(const Eigen::VectorXd& source, const Eigen::VectorXd& target) const = 0;
};

}  // namespace leastcost
