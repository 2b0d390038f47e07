// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include <leastcost/framework/check/faults.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

struct CheckCostOptions {
  int samples = 5;               ///< paths through four random points each
  double defect_order = 2;       ///< of c(a, m) + c(m, b) - c(a, b), relative, where not additive; see below
  bool linear_residual = false;  ///< the Gauss-Newton Hessian is claimed to be the exact one
  std::vector<Eigen::VectorXd> outside = {};  ///< points where every move must have infinite cost
};

/// What a cost promises (SegmentCost, CostTraits), measured at random points well inside its domain, typical moves and
/// moves of 1e-8. No fault found is no proof. Deterministic for a given engine; prints nothing; throws what the cost
/// throws. Names of faults:
///
///     value            q is negative, NaN or infinite at a sample, or 0 between two points
///     repeatable       two calls give different numbers: an entry is not initialised
///     rest             c(x, x) is not 0
///     symmetric, additive, below_curves      declared in CostTraits, and not so
///     defect_order     not additive, and c(a, m) + c(m, b) does not approach c(a, b) at the order that the certificate
///                      extrapolates with: c is no cost per length in the limit
///     value_and_gradient                     value<double> and value<Dual> (or gradient()) give different q
///     gradient, hessian                      are not the derivatives of the energy (Taylor slopes 2 and 3)
///     fixed_ends       derivatives in the ends of an open path, which are constants
///     hessian_symmetry, gauss_newton         a block is not symmetric; a Gauss-Newton block has negative eigenvalues
///     residual, residual_jacobian            |r|^2 is not q; 2 J'r is not its gradient
///     line_element     is not the limit of c(x, x + e v) / e, or not proportional to the length of v
///     quadratic_at_rest                      declared, but half the Hessian of q at a = b is not the metric of the
///                      line element: q is not twice differentiable there (Finsler: set the trait to false)
///     enclosure        the metric in intervals (EnclosesMetric) is not that of the line element
///     outside          a move to or from a given outside point is not infinitely expensive
std::vector<Fault> check_cost(const SegmentCost& cost, const PointSampler& inside, std::mt19937_64& engine,
                              const CheckCostOptions& options = {});

/// The part about derivatives, along a path of the caller's (d x columns, no two equal neighbours): a ring if `ring`,
/// then the last column is the first again; else its ends are constants.
std::vector<Fault> check_cost_derivatives(const SegmentCost& cost, const Points& path, bool ring,
                                          std::mt19937_64& engine);

}  // namespace leastcost
