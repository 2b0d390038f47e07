// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/constraint.hpp>

#include <ompl/base/ConstrainedSpaceInformation.h>
#include <ompl/base/Constraint.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include "tests/ompl/plans.hpp"

namespace leastcost::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

std::shared_ptr<const ConstraintManifold> surface(const std::string& name) {
  if (name == "sphere") return make_implicit_manifold({.surface = implicit::Sphere{}});
  return make_implicit_manifold({.surface = implicit::Torus{}});
}

/// Distance from the surfaces by their own closed forms.
double off_surface(const std::string& name, const Eigen::Vector3d& x) {
  if (name == "sphere") return std::abs(x.norm() - 1);
  return std::abs(std::hypot(std::hypot(x[0], x[1]) - 2, x[2]) - 1);
}

}  // namespace

TEST_CASE("ompl constraint: its function is as long as the distance, its Jacobian is its derivative") {
  const auto constraint = make_constraint(surface("torus"));
  REQUIRE(constraint->getCoDimension() == 1);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d x(any(random), any(random), any(random) / 3);
    if (std::hypot(x[0], x[1]) < 0.3 || std::hypot(std::hypot(x[0], x[1]) - 2, x[2]) < 0.1)
      continue;  // no nearest point
    Eigen::VectorXd value(1), ahead(1);
    Eigen::MatrixXd slope(1, 3);
    constraint->function(x, value);
    constraint->jacobian(x, slope);
    CHECK(std::abs(value[0]) == Approx(off_surface("torus", x)).margin(1e-12));
    CHECK(constraint->distance(x) == Approx(off_surface("torus", x)).margin(1e-12));
    for (int k = 0; k < 3; ++k) {
      const double step = 1e-6;
      Eigen::VectorXd moved = x;
      moved[k] += step;
      constraint->function(moved, ahead);
      CHECK((ahead[0] - value[0]) / step == Approx(slope(0, k)).margin(1e-4));
    }
  }
}

TEST_CASE("ompl constraint: plans on surfaces stay on them, and are polished there") {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  const std::string name = GENERATE("torus", "sphere");
  CAPTURE(name);
  const auto domain = surface(name);
  const auto space = std::make_shared<ob::ProjectedStateSpace>(square(3, -4, 4), make_constraint(domain));
  const auto information = std::make_shared<ob::ConstrainedSpaceInformation>(space);
  og::SimpleSetup setup(information);
  setup.setStateValidityChecker([](const ob::State*) { return true; });
  ob::ScopedState<> start(space), goal(space);
  const Eigen::VectorXd from = project_end(*domain, Eigen::Vector3d(3, 0, 0)).u;
  const Eigen::VectorXd to = project_end(*domain, Eigen::Vector3d(-1.5, -2.0, 0.8)).u;
  start->as<ob::ConstrainedStateSpace::StateType>()->copy(from);
  goal->as<ob::ConstrainedStateSpace::StateType>()->copy(to);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(information));
  REQUIRE(setup.solve(10.0) == ob::PlannerStatus::EXACT_SOLUTION);
  og::PathGeometric plan = setup.getSolutionPath();
  const Points given = columns_of(plan);
  for (const auto& x : given.colwise()) CHECK(off_surface(name, x) < 1e-7);

  const Polished ours = polish(plan, {.domain = domain});
  CHECK(ours.outcome == PolishOutcome::polished);
  CHECK(ours.certified());
  CHECK(ours.cost <= ours.given_cost);
  const Points x = columns_of(*ours.path);
  for (const auto& place : x.colwise()) CHECK(off_surface(name, place) < 1e-9);
  if (name == "sphere")  // a great circle
    CHECK(ours.result.certificate.estimate.value == Approx(std::acos(from.dot(to))).epsilon(1e-6));
  CHECK_THROWS_AS(polish(plan), InputError);
  CHECK_THROWS_WITH(polish(plan), Catch::Contains("the space is constrained: give the domain of its states"));
}

TEST_CASE("ompl constraint: places without a nearest point, and far ones") {
  const auto constraint = make_constraint(surface("sphere"));
  Eigen::VectorXd centre = Eigen::Vector3d::Zero();
  CHECK_FALSE(constraint->project(centre));
  CHECK_FALSE(constraint->isSatisfied(centre));
  Eigen::VectorXd nowhere = Eigen::Vector3d(std::nan(""), 0, 0);
  CHECK_FALSE(constraint->isSatisfied(nowhere));
  Eigen::VectorXd far = Eigen::Vector3d(30, 40, 0);
  REQUIRE(constraint->project(far));
  CHECK((far - Eigen::Vector3d(0.6, 0.8, 0)).norm() < 1e-12);
}

TEST_CASE("ompl constraint: what is no constraint is refused") {
  CHECK_THROWS_AS(make_constraint(nullptr), InputError);
  CHECK_THROWS_AS(make_constraint(surface("torus"), 0), InputError);
  CHECK_THROWS_AS(make_constraint(surface("torus"), std::nan("")), InputError);
  CHECK_THROWS_AS(make_constraint(std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3})),
                  InputError);
  CHECK_THROWS_WITH(make_constraint(std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3})),
                    Catch::Contains("this domain fills its space of 3 dimensions, so it needs no constraint"));
}

}  // namespace leastcost::test
