// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/path/kernel.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// What the certificate may rely on. The defaults claim nothing.
struct CostTraits {
  std::string unit = "cost";  ///< in words: "length", "s"
  bool symmetric = true;      ///< c(a, b) = c(b, a)
  bool additive = false;      ///< c(a, b) = c(a, m) + c(m, b) for m on the segment: c is exact for a straight move
  bool below_curves = false;  ///< c(a, b) <= cost of every curve from a to b (chords)
  /// q(x, x + v) = v' G v + o(|v|^2) with a metric G(x): q is twice differentiable at a = b. A Finsler cost, where c is
  /// a norm without an inner product, has none. Methods that work with the metric (georce) refuse such a cost.
  bool quadratic_at_rest = true;
};

/// Second derivatives, or the part of them that is never negative.
enum class HessianKind { exact, gauss_newton };

/// Second derivatives of phi(q(a, b) / s0^2), one 2d x 2d block per segment over (a, b), side by side: 2d x 2dN.
struct ChainBlocks {
  Points blocks;  ///< a square block for every segment, side by side
};

/// The cost of straight moves along a path, through q = c^2 (docs/numerics.md Sec. 1.1: smooth where c is not). One
/// virtual call per path; cost authors write a SegmentCostFunction (framework/cost/segment_cost_function.hpp) and lift
/// it. Values are >= 0 or +infinity outside the domain of the cost, never NaN. Immutable, hence shareable between
/// threads.
///
/// Derivatives treat the ends of an open path as constants: their columns and blocks are zero
/// (AmbientPath::begin_fixed, end_fixed). A long path may be handed over in parts, with a look at the clock between
/// them.
class SegmentCost : public HasAbilities<SegmentCost> {
 public:
  virtual int dim() const = 0;                   ///< ambient dimension d
  virtual const CostTraits& traits() const = 0;  ///< what solvers and proofs may rely on

  /// q of each segment; q.size() == path.segment_count().
  virtual void squared_costs(const AmbientPath& path, std::span<double> q) const = 0;

  /// sum_i phi(q_i / s0^2), and its gradient into `gradient` (d x (N + 1), overwritten). VFCS Eqs. (9), (10).
  virtual double energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                                     Eigen::Ref<Points> gradient) const = 0;

  /// Second derivatives per segment. gauss_newton is positive semidefinite for every convex increasing H.
  virtual void chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                            ChainBlocks& out) const = 0;

  /// The residual form of the energy, for least-squares solvers: r_i with |r_i|^2 = q_i, one column per segment (rows x
  /// N), and unless null its Jacobians over (a, b), side by side: rows x 2dN, zero for the ends of an open path.
  virtual void residuals(const AmbientPath& path, Points& r, Points* jacobians) const = 0;

  /// lim c(x, x + e v) / e for e -> 0+: the cost per unit of parameter of a curve through x with velocity v.
  virtual double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const = 0;
};

/// Ability: the cost can say in words why a move costs infinitely much.
class ExplainsInfinity {
 public:
  virtual ~ExplainsInfinity() = default;
  /// Empty where it does not know, or where the move has a cost. Ends a sentence: "... is infinite: <why>".
  virtual std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const = 0;
};

/// ": " and the reason why the move a -> b costs infinitely much, where the cost knows it; else nothing.
std::string reason_for_infinity(const SegmentCost& cost, const Eigen::VectorXd& a, const Eigen::VectorXd& b);

class ConstraintManifold;

/// Ability: the cost is made from the data of the domain (tensors on the points of a cloud), so that on a coarser
/// version of the domain it is another one. What the data costs the path is then part of the geometry error.
class FollowsDomain {
 public:
  virtual ~FollowsDomain() = default;
  /// The same cost from the data of another version of the domain. May throw InputError.
  virtual std::shared_ptr<const SegmentCost> on(const ConstraintManifold& domain) const = 0;
};

/// Costs c_i of the segments, and their sum.
Eigen::VectorXd segment_costs(const SegmentCost& cost, const AmbientPath& path);
/// Sum over the segments of a path.
double total_cost(const SegmentCost& cost, const AmbientPath& path);

/// c(a, b) of one move.
double move_cost(const SegmentCost& cost, const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace leastcost
