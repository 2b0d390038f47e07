// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// OMPL plans on a torus of ours, and leastcost polishes the plan on it.
#include <ompl/base/ConstrainedSpaceInformation.h>
#include <ompl/base/Constraint.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <cstdio>

#include <leastcost/ompl/ompl.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>

using namespace leastcost;
namespace ob = ompl::base;
namespace og = ompl::geometric;

int main() {
  const auto torus = make_implicit_manifold({.surface = implicit::Torus{.major_radius = 2, .minor_radius = 1}});
  auto around = std::make_shared<ob::RealVectorStateSpace>(3);
  around->setBounds(-4, 4);
  auto space = std::make_shared<ob::ProjectedStateSpace>(around, make_constraint(torus));
  og::SimpleSetup setup(std::make_shared<ob::ConstrainedSpaceInformation>(space));
  setup.setStateValidityChecker([](const ob::State*) { return true; });
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  ob::ScopedState<> start(space), goal(space);
  start->as<ob::ConstrainedStateSpace::StateType>()->copy(Eigen::Vector3d(3, 0, 0));
  goal->as<ob::ConstrainedStateSpace::StateType>()->copy(Eigen::Vector3d(0, 2, 1));
  setup.setStartAndGoalStates(start, goal);
  if (!setup.solve(5.0)) return 1;

  const Polished plan = polish(setup.getSolutionPath(), {.domain = torus});
  std::printf("%s: %.4f instead of %.4f\n", plan.certified() ? "certified" : "uncertified",
              plan.result.certificate.estimate.value, plan.given_cost);
  return plan.certified() ? 0 : 1;
}
