// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <leastcost/framework/domain/sees_bounds.hpp>
#include <leastcost/framework/energy/chain_model.hpp>

namespace leastcost {

/// The step of a chain's model that heeds the bounds beside all points at once, those that no point lies on yet among
/// them: a quadratic program (least_of_chain()) between bounds taken to be straight. Cut off where single points meet
/// bounds, a step of the whole chain gains nothing unless it is shortened until hardly any point moves; this one comes
/// to rest on the bounds that will hold it. (A step of sequential quadratic programming: Nocedal and Wright 2006,
/// Ch. 18.)
///
/// No point moves farther than a radius that follows the steps which were taken. Bounds are straight only near by, and
/// those within reach of a long step are many: a step that is cut down after the program has heeded walls which it
/// never comes near. A step too long is shortened by adding a multiple of the identity to the Hessian (ibid., Ch. 4.3),
/// in which the stiff directions keep their moves.
class BoundedStep {
 public:
  explicit BoundedStep(PathEnergy& energy);

  /// Whether the domain sees bounds (SeesBounds).
  bool possible() const { return bounds_ != nullptr; }

  /// Where the domain sees bounds and the model's own step would pass over one, or is longer than the radius: solves
  /// for the step that does not. False elsewhere, for a ring, and where that fails; then there is no such step.
  bool solve(const CoordinatePath& path, const ChainModel& model);

  const Points& moves() const { return moves_; }  ///< coordinate x n
  double slope() const { return slope_; }         ///< of the energy along the step, below 0
  /// The whole step, onto the bounds that it ends on.
  void retract(const CoordinatePath& from, CoordinatePath& to) const;
  /// Of a step that heeds no bounds: how much of it the radius leaves, 1 where that is all.
  double part_within(const Points& moves) const;
  /// A step with this largest move was taken, or what its trials left of it: the next radius.
  void took(double length, bool all);

 private:
  bool passes_bounds(const CoordinatePath& path, const Points& moves);
  bool reaches_many_bounds(const CoordinatePath& path, const Points& moves) const;
  std::optional<Eigen::VectorXd> least_within_bounds(double length, const Eigen::VectorXd& force);
  bool find_hessian(const CoordinatePath& path, const ChainModel& model);
  bool shorten(const Eigen::VectorXd& gradient);
  void end_on_bounds(double length);

  PathEnergy& energy_;
  const SeesBounds* bounds_;
  std::vector<std::vector<NearBound>> near_;  ///< of each free point
  Frames frames_;                             ///< without blocked directions
  ChainSystem hessian_, scaled_;
  Points moves_;
  double slope_ = 0;
  double radius_ = std::numeric_limits<double>::infinity();
  BoundsOfPoints ends_on_;
};

}  // namespace leastcost
