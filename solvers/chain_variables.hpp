// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/solvers/preconditioner.hpp>

namespace leastcost {

/// Unconstrained variables z around a path x0, for minimisers that know only a vector, a value and a gradient:
///
///     x(z) = R(x0, T S z),
///
/// with the tangent frames T at x0, the domain's own retraction R, and for `chain` S = L^-T, L the Cholesky factor of
/// the Gauss-Newton chain Hessian there (docs/numerics.md Sec. 3.6: the energy is then about |z|^2 / 2 around its
/// minimum, at every n), for `none` S a number, one for all rounds, that makes the first gradient a move of a tenth of
/// a segment: back ends try a step of that size first. Directions that a bound blocks are left out of T: the variables
/// are the free set of x0. Where a move goes beyond a bound that is not among them, there is no x(z).
class ChainVariables {
 public:
  ChainVariables(PathEnergy& energy, Preconditioner scaling) : energy_(energy), scaling_(scaling) {}

  /// Centres the variables at a path, z = 0 there. False where the energy is not finite.
  bool centre(const CoordinatePath& path);
  const CoordinatePath& base() const { return base_; }  ///< the chain at which all variables are 0
  const ChainModel& model() const { return model_; }    ///< at the centre, solved with the Gauss-Newton Hessian
  Index size() const { return model_.tangent.size(); }  ///< number of variables
  /// S for `none`.
  double scale() const { return scale_; }

  /// x(z), or the nearest feasible path; whether it is x(z) itself.
  bool path_at(const Eigen::VectorXd& z, CoordinatePath& path);
  /// The gradient in z, from the gradient at x(z) in coordinates.
  void pull_back(const Eigen::VectorXd& z, const Points& path_gradient, Eigen::VectorXd& gradient);

  /// Cosine of the largest angle by which a tangent plane at x(z) has turned from that at x0: far from 1 the variables
  /// are no longer good ones.
  double turned(const CoordinatePath& path) const;

 private:
  double first_scale() const;
  Points steps(const Eigen::VectorXd& z) const;
  void to_tangent(const Eigen::VectorXd& z, const Points& path_gradient, Eigen::VectorXd& gradient);

  PathEnergy& energy_;
  Preconditioner scaling_;
  CoordinatePath base_, plus_, minus_;
  ChainModel model_;
  double scale_ = 0;  ///< S for `none`
};

}  // namespace leastcost
