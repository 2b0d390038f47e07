// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A plan of RRTConnect for a planar body among two pillars, polished. The planner's own checker says how far it is from
// them, so that the clearance is proved.
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <leastcost/ompl/ompl.hpp>

using namespace leastcost;
namespace ob = ompl::base;
namespace og = ompl::geometric;

/// A round body of radius 0.3 among pillars of radius 1.
class Pillars : public ob::StateValidityChecker {
 public:
  using ob::StateValidityChecker::StateValidityChecker;
  bool isValid(const ob::State* state) const override { return clearance(state) >= 0; }
  double clearance(const ob::State* state) const override {
    const auto& pose = *state->as<ob::SE2StateSpace::StateType>();
    return std::min(std::hypot(pose.getX() - 3, pose.getY() - 4.5), std::hypot(pose.getX() - 7, pose.getY() - 5.5)) -
           1.3;
  }
};

int main() {
  auto space = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0);
  bounds.setHigh(10);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  setup.setStateValidityChecker(std::make_shared<Pillars>(setup.getSpaceInformation()));
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  start->setXY(1, 5);
  start->setYaw(3);
  goal->setXY(9, 5);
  goal->setYaw(-3);
  setup.setStartAndGoalStates(start, goal);
  if (!setup.solve(5.0)) return 1;

  // A true distance has the Lipschitz constant 1, and 1 from the axis of a pillar it is bent by at most 1 / 1.
  const DistanceChecker distance{.curvature = 1, .curvature_from = -0.3, .clearance = 0.05, .size = 10};
  const Polished plan = polish(setup.getSolutionPath(), {.distance = distance});
  std::printf("%s, %s: %.3f instead of %.3f, %.2g more than the clearance\n", word_of(plan.outcome).data(),
              plan.certified() ? "certified" : "uncertified", plan.cost, plan.given_cost, plan.clearance->lower);
  return plan.certified() && plan.path->check() ? 0 : 1;
}
