// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// RRT* minimises a cost of ours, a length that is dearer to the right, and leastcost goes on from its plan with the
// same cost.
#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <cstdio>

#include <leastcost/ompl/ompl.hpp>
#include <leastcost/problems/costs/metric_field.hpp>

using namespace leastcost;
namespace ob = ompl::base;
namespace og = ompl::geometric;

int main() {
  const auto cost = make_metric_field_cost({.field = metric::Formula{{"1 + x*x", "0", "1 + x*x"}, {}}}, 2);
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(-3, 3);
  og::SimpleSetup setup(space);
  setup.setStateValidityChecker([](const ob::State*) { return true; });
  setup.setOptimizationObjective(make_objective(setup.getSpaceInformation(), cost));
  setup.setPlanner(std::make_shared<og::RRTstar>(setup.getSpaceInformation()));
  ob::ScopedState<> start(space), goal(space);
  start[0] = goal[0] = 2;
  start[1] = -2;
  goal[1] = 2;
  setup.setStartAndGoalStates(start, goal);
  if (!setup.solve(0.3)) return 1;

  const Polished plan = polish(setup.getSolutionPath(), {.cost = cost});
  std::printf("%s: %.4f instead of %.4f\n", plan.certified() ? "certified" : "uncertified", plan.cost, plan.given_cost);
  return plan.certified() && plan.cost < plan.given_cost ? 0 : 1;
}
