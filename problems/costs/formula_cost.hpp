// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

struct FormulaCostOptions {
  std::string lagrangian = {};  ///< F(x, v) in x, y, z and vx, vy, vz; in more dimensions x0, x1, ... and v0, v1, ...
  std::map<std::string, double> parameters = {};
  bool convexify = false;
  std::string unit = "cost";
  void fields(FieldVisitor& visit);
};

/// Where a formula is checked, ambient: lower and upper corners.
struct CheckedRegion {
  Eigen::VectorXd lower, upper;  ///< corners of the box in which it is used
};

/// The integral of F(x, dx): c(a, b) = F(m, b - a) with the middle m, second order. F is a cost per length: positive
/// for v != 0, F(x, l v) = l F(x, v) for l > 0, strictly convex across v (Finsler; Bao, Chern, Shen, "An Introduction
/// to Riemann-Finsler Geometry", 2000). F(x, -v) may be another number: the cost is then asymmetric, and says so unless
/// its formula proves that it is not. What is checked: problems/costs/lagrangian/lagrangian_check.hpp; the result has a
/// note (HasNotes) whether it was proved in the region, by intervals, or sampled. What is refuted there is refused.
///
/// Where F is sqrt of a form of second degree in v, by what its text says, it is a length under a metric, and
/// certificates can be proved (EnclosesMetric). Elsewhere the line element is F, never a Hessian at a = b, which does
/// not exist there (`quadratic_at_rest` is false).
///
/// `convexify`, in the plane: F is replaced by its convex hull in v, what zigzags make of it; where a path follows a
/// direction between those of a zigzag it is not unique.
///
/// +infinity where F is not positive or not finite. Throws OptionError.
std::shared_ptr<const SegmentCost> make_formula_cost(const FormulaCostOptions& options, int dim,
                                                     const std::optional<CheckedRegion>& region);

/// The box of a flat domain where it is finite, else that of the ends, with sides of half the longest at least; none
/// where there are no ends.
std::optional<CheckedRegion> checked_region(const ConstraintManifold& domain,
                                            const std::optional<Eigen::VectorXd>& source,
                                            const std::optional<Eigen::VectorXd>& target);

/// The names that stand for v beside those of the coordinates: vx, vy, vz, or v0, v1, ...
std::vector<std::string> velocity_names(int dim);

}  // namespace leastcost
