// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/objective.hpp>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/ompl/state_columns.hpp>

namespace leastcost {
namespace {

namespace ob = ompl::base;

class SegmentObjective final : public ob::OptimizationObjective {
 public:
  SegmentObjective(const ob::SpaceInformationPtr& space, StateColumns columns, std::shared_ptr<const SegmentCost> cost)
      : ob::OptimizationObjective(space), columns_(std::move(columns)), cost_(std::move(cost)) {
    description_ = "leastcost: " + cost_->traits().unit;
  }

  ob::Cost stateCost(const ob::State*) const override { return identityCost(); }

  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    const Eigen::VectorXd a = columns_.column(*from);
    Eigen::VectorXd b = columns_.column(*to);
    columns_.unwrap(a, b);
    return ob::Cost(move_cost(*cost_, a, b));
  }

  bool isSymmetric() const override { return cost_->traits().symmetric; }

 private:
  StateColumns columns_;
  std::shared_ptr<const SegmentCost> cost_;
};

}  // namespace

std::shared_ptr<ob::OptimizationObjective> make_objective(const std::shared_ptr<ob::SpaceInformation>& space,
                                                          std::shared_ptr<const SegmentCost> cost) {
  if (!space || !cost) throw InputError("an objective needs a SpaceInformation and a cost");
  StateColumns columns(space->getStateSpace());
  if (columns.rows() != cost->dim())
    throw InputError("the cost has " + std::to_string(cost->dim()) + " dimensions, but states of the space have " +
                     std::to_string(columns.rows()));
  return std::make_shared<SegmentObjective>(space, std::move(columns), std::move(cost));
}

}  // namespace leastcost
