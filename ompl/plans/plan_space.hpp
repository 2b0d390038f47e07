// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <random>
#include <utility>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/ompl/state_columns.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A planner's space as columns: what is free there, and what paths cost. Has states of its own to ask with: one thread
/// at a time.
class PlanSpace {
 public:
  PlanSpace(std::shared_ptr<ompl::base::SpaceInformation> space, StateColumns columns,
            std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const SegmentCost> cost);
  ~PlanSpace();
  PlanSpace(const PlanSpace&) = delete;
  PlanSpace& operator=(const PlanSpace&) = delete;

  bool is_free(const Eigen::VectorXd& x) const;  ///< in bounds, and valid
  /// Clear of the walls; true where there are none to look at.
  bool clear_of_walls(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  /// Whether there are bounds, and poses in them are places.
  bool has_random_places() const { return columns_.has_quaternions() && columns_.bounded(); }
  /// A place within the bounds, uniform in each part of the space.
  Eigen::VectorXd random_place(std::mt19937_64& engine) const { return columns_.random(engine); }
  /// Of the columns that name the same state as b the one that is nearest to a: where the planner's move from a ends.
  /// In flat spaces b.
  Eigen::VectorXd seen_from(const Eigen::VectorXd& a, Eigen::VectorXd b) const {
    if (!is_flat()) columns_.unwrap(a, b);
    return b;
  }
  /// By the planner's motion validator, and clear of the walls where there are any to look at.
  bool moves(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  bool planner_moves(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;  ///< by its validator alone
  void look_at(std::shared_ptr<const Walls> walls) { walls_ = std::move(walls); }
  const Walls* walls() const { return walls_.get(); }
  const ConstraintManifold& domain() const { return *domain_; }
  const SegmentCost& move_costs() const { return *cost_; }
  /// As the checker of the planner says.
  double clearance(const Eigen::VectorXd& x) const;
  /// Whether parts of a move are the same motion: of straight lines, not of the chords of a turn.
  bool is_flat() const { return domain_->shape() == Shape::flat; }
  /// Whether the planner's own move between states is straight in the columns.
  bool straight(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

  /// t of the way from a to b, on the domain where there is a nearest point of it.
  Eigen::VectorXd between(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double t) const;
  double cost(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  /// Of a polyline; in pieces of at most `longest` where a move does not cost what its parts do.
  double cost(const Points& x, double longest) const;
  double cost(const Points& x) const { return cost(x, 0); }

 private:
  std::shared_ptr<ompl::base::SpaceInformation> space_;
  StateColumns columns_;
  std::shared_ptr<const ConstraintManifold> domain_;
  std::shared_ptr<const SegmentCost> cost_;
  std::shared_ptr<const Walls> walls_ = {};
  ompl::base::State *from_, *to_, *middle_;
};

}  // namespace leastcost
