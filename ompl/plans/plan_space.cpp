// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/plans/plan_space.hpp"

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leastcost {
namespace {

constexpr double kStraight = 1e-6;  ///< of the length of a move

}  // namespace

PlanSpace::PlanSpace(std::shared_ptr<ompl::base::SpaceInformation> space, StateColumns columns,
                     std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const SegmentCost> cost)
    : space_(std::move(space)),
      columns_(std::move(columns)),
      domain_(std::move(domain)),
      cost_(std::move(cost)),
      from_(space_->allocState()),
      to_(space_->allocState()),
      middle_(space_->allocState()) {}

PlanSpace::~PlanSpace() {
  for (ompl::base::State* state : {from_, to_, middle_}) space_->freeState(state);
}

bool PlanSpace::is_free(const Eigen::VectorXd& x) const {
  columns_.write(x, *from_);
  return space_->satisfiesBounds(from_) && space_->isValid(from_);
}

bool PlanSpace::clear_of_walls(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  return !walls_ || clears(*walls_, a, b);
}

bool PlanSpace::planner_moves(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  columns_.write(a, *from_);
  columns_.write(b, *to_);
  return space_->checkMotion(from_, to_);
}

/// What is quicker first; it may ask is_free(), which writes states.
bool PlanSpace::moves(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  return clear_of_walls(a, b) && planner_moves(a, b);
}

double PlanSpace::clearance(const Eigen::VectorXd& x) const {
  columns_.write(x, *from_);
  return space_->getStateValidityChecker()->clearance(from_);
}

bool PlanSpace::straight(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  columns_.write(a, *from_);
  columns_.write(b, *to_);
  const double length = space_->distance(from_, to_);
  space_->getStateSpace()->interpolate(from_, to_, 0.5, middle_);
  columns_.write(between(a, b, 0.5), *to_);
  return space_->distance(middle_, to_) <= kStraight * length;
}

Eigen::VectorXd PlanSpace::between(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double t) const {
  Eigen::VectorXd x = (1 - t) * a + t * b;
  if (is_flat()) return x;
  CoordinatePath alone{x, {}, true};
  domain_->project(alone);
  return alone.u;
}

double PlanSpace::cost(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return move_cost(*cost_, a, b); }

double PlanSpace::cost(const Points& x, double longest) const {
  const bool whole = !(longest > 0) || (cost_->traits().additive && is_flat());
  double sum = 0;
  for (Index i = 0; i + 1 < x.cols(); ++i) {
    const Eigen::VectorXd a = x.col(i), b = x.col(i + 1);
    const double length = (b - a).norm(), pieces = whole ? 1 : std::max(1.0, std::ceil(length / longest));
    Eigen::VectorXd here = a;
    for (double k = 1; k <= pieces && length > 0; ++k) {
      const Eigen::VectorXd next = k < pieces ? between(a, b, k / pieces) : b;
      sum += cost(here, next);
      here = next;
    }
  }
  return sum;
}

}  // namespace leastcost
