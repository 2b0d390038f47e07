// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Ability of a domain that knows how it bends; of others second differences of the retraction are taken
/// (PathEnergy::chain_hessian), some sixty retractions of the path in seven dimensions.
class HasCurvature {
 public:
  virtual ~HasCurvature() = default;
  bool present() const { return knows_curvature(); }
  /// The second derivative at 0 of gradient'R(step) by the step of a column, R being the retraction without bounds but
  /// those that hold the column: coordinate x coordinate, true for steps along the domain and along these. False where
  /// nothing bends; then `bend` is not set. gradient: in coordinates, of what is to be lowered.
  virtual bool bend(const CoordinatePath& path, Index column, const Eigen::VectorXd& gradient, Points& bend) const = 0;

 private:
  virtual bool knows_curvature() const = 0;
};

}  // namespace leastcost
