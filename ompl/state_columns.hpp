// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <random>
#include <vector>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/ompl/forward.hpp>

namespace leastcost {

/// The states of an OMPL space as columns of numbers, and back:
///
/// | space | rows |
/// |---|---|
/// | R^n | its n values |
/// | SO(2) | the angle on its universal cover: along a path it goes on beyond pi |
/// | SO(3) | the unit quaternion x, y, z, w; along a path of the two that name a rotation the nearer one |
/// | compound (SE(2), SE(3), ...) | those of its parts, one below the other |
/// | constrained | those of the space that it is in |
///
/// Moves of the space are straight in them, on the unit sphere for a quaternion. Immutable.
///
/// `turn`: angles are multiplied by it, and quaternions have its length. Beside lengths it says how far a turn by one
/// radian counts as, so that steps and gaps compare like with like: for a body, how far its farthest point is from its
/// origin, twice that where it has quaternions, which change by half the angle.
class StateColumns {
 public:
  /// Throws InputError for a space with a part that is none of these, and a turn that is no positive number.
  explicit StateColumns(std::shared_ptr<const ompl::base::StateSpace> space, double turn = 1);

  Index rows() const { return rows_; }                             ///< coordinates of a column
  bool has_quaternions() const { return !quaternions().empty(); }  ///< whether some of them are rotations
  std::vector<Index> quaternions() const;                          ///< their first rows, ascending
  /// Of a constrained space: where its states may be is not known from it.
  bool constrained() const { return constrained_; }

  /// The coordinates of a state.
  Eigen::VectorXd column(const ompl::base::State& state) const;
  /// Throws InputError for a state whose numbers are not finite, or a quaternion of no length.
  Points columns(const ompl::geometric::PathGeometric& path) const;
  /// Angles are brought into [-pi, pi), quaternions to length one there.
  void write(const Eigen::VectorXd& column, ompl::base::State& state) const;
  /// A state per column. Throws InputError for columns of another size.
  std::shared_ptr<ompl::geometric::PathGeometric> path(const std::shared_ptr<ompl::base::SpaceInformation>& space,
                                                       const Points& columns) const;

  /// Of the columns that name the same state as `column`, the one nearest to `before`.
  void unwrap(const Eigen::VectorXd& before, Eigen::Ref<Eigen::VectorXd> column) const;
  /// Quaternions to the length that they have in columns; false where one has none.
  bool settle(Eigen::Ref<Eigen::VectorXd> column) const;

  /// Whether random() may be asked: reals have finite bounds, and states no constraint.
  bool bounded() const;
  /// Uniform within the bounds of reals, and over all angles and rotations.
  Eigen::VectorXd random(std::mt19937_64& engine) const;

  /// Where the columns may be: on the sphere for a quaternion, elsewhere within the bounds of the space (beside a
  /// quaternion it does not know the bounds). Throws InputError for a constrained space.
  std::shared_ptr<const ConstraintManifold> domain() const;
  /// The length in these rows, each part times its weight in the space: in R^n, SO(2) and SO(3) what OMPL calls the
  /// length; of a compound space the root of the sum of their squares, where OMPL adds them.
  std::shared_ptr<const SegmentCost> length() const;
  /// OMPL's distance of two states is at most this times the distance of their columns.
  double steepness() const;

 private:
  enum class Kind { reals, angle, quaternion };
  struct Part {
    Kind kind = Kind::reals;
    Index row = 0, count = 1;
    double weight = 1;
    std::vector<unsigned> within;  ///< which component of which compound state, from the outermost on
    const ompl::base::StateSpace* space = nullptr;
  };
  void add(const ompl::base::StateSpace& space, double weight, const std::vector<unsigned>& within);
  double* values(const Part& part, ompl::base::State& state) const;

  double in_columns(const Part& part) const { return part.kind == Kind::reals ? 1 : turn_; }

  std::shared_ptr<const ompl::base::StateSpace> space_;
  double turn_;
  std::vector<Part> parts_;
  Index rows_ = 0;
  bool constrained_ = false;
};

}  // namespace leastcost
