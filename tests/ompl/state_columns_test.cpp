// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/state_columns.hpp>

#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/check/check_manifold.hpp>
#include "tests/ompl/plans.hpp"

namespace leastcost::test {
namespace {

namespace ob = ompl::base;

/// A turn about an axis.
Eigen::Vector4d turn(const Eigen::Vector3d& axis, double angle) {
  Eigen::Vector4d q;
  q << std::sin(angle / 2) * axis.normalized(), std::cos(angle / 2);
  return q;
}

}  // namespace

TEST_CASE("ompl columns: states of every space come back as they went") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-3, 3);
  const auto arm = std::make_shared<ob::CompoundStateSpace>();
  arm->addSubspace(planar_poses(), 2);
  arm->addSubspace(std::make_shared<ob::SO2StateSpace>(), 0.5);
  arm->addSubspace(std::make_shared<ob::SO3StateSpace>(), 1);
  arm->addSubspace(square(3, -4, 4), 1);
  const std::vector<std::pair<ob::StateSpacePtr, Index>> spaces = {{square(5, -4, 4), 5},
                                                                   {planar_poses(), 3},
                                                                   {poses(), 7},
                                                                   {std::make_shared<ob::SO2StateSpace>(), 1},
                                                                   {std::make_shared<ob::SO3StateSpace>(), 4},
                                                                   {arm, 3 + 1 + 4 + 3}};
  for (const auto& [space, rows] : spaces) {
    CAPTURE(space->getName());
    const PlannerSpace information = open_space(space);
    const StateColumns columns(space);
    REQUIRE(columns.rows() == rows);
    const auto sampler = information->allocStateSampler();
    PlannerPath path(information);
    ob::ScopedState<> state(space);
    for (int i = 0; i < 40; ++i) {
      sampler->sampleUniform(state.get());
      path.append(state.get());
    }
    const auto back = columns.path(information, columns.columns(path));
    REQUIRE(back->getStateCount() == path.getStateCount());
    for (unsigned i = 0; i < path.getStateCount(); ++i) {
      CHECK(information->distance(path.getState(i), back->getState(i)) < 1e-7);  // acos near 1 of quaternions
      CHECK(information->satisfiesBounds(back->getState(i)));
    }
  }
}

TEST_CASE("ompl columns: the rows of a pose are x, y, yaw") {
  const PlannerSpace space = open_space(planar_poses());
  ob::ScopedState<ob::SE2StateSpace> state(space);
  state->setXY(1, -2);
  state->setYaw(0.5);
  CHECK(StateColumns(space->getStateSpace()).column(*state.get()) == Eigen::Vector3d(1, -2, 0.5));
}

TEST_CASE("ompl columns: half a turn is within OMPL's bounds, whichever way around") {
  const PlannerSpace space = open_space(planar_poses());
  const StateColumns columns(space->getStateSpace());
  ob::ScopedState<ob::SE2StateSpace> state(space);
  for (const double turns : {-2.5, -1.5, -0.5, 0.5, 1.5, 2.5}) {
    const double angle = turns * 2 * std::numbers::pi;
    columns.write(Eigen::Vector3d(0, 0, angle), *state.get());
    CHECK(space->satisfiesBounds(state.get()));
    CHECK(std::cos(state->getYaw()) == Approx(-1));
    CHECK(columns.column(*state.get())[2] == Approx(-std::numbers::pi));
  }
}

TEST_CASE("ompl columns: an angle goes on beyond the seam, the shorter way around as OMPL goes") {
  const PlannerSpace space = open_space(planar_poses());
  Points given(3, 6);  // three quarters of a turn at a time would go the other way: steps of 2 go on and on
  for (Index i = 0; i < 6; ++i)
    given.col(i) = Eigen::Vector3d(0.1 * static_cast<double>(i), 0, 2.0 * static_cast<double>(i));
  const PlannerPath path = path_through(space, given);
  for (unsigned i = 0; i < path.getStateCount(); ++i)
    CHECK(std::abs(path.getState(i)->as<ob::SE2StateSpace::StateType>()->getYaw()) <= std::numbers::pi);
  CHECK((columns_of(path) - given).cwiseAbs().maxCoeff() < 1e-12);
  double turned = 0;  // by OMPL's own measure
  for (unsigned i = 0; i + 1 < path.getStateCount(); ++i)
    turned += space->distance(path.getState(i), path.getState(i + 1)) - 0.1;
  CHECK(turned == Approx(0.5 * 10));
}

TEST_CASE("ompl columns: along a path a quaternion keeps its sign, whichever of the two a state has") {
  const PlannerSpace space = open_space(poses());
  Points given = Points::Zero(7, 20);
  for (Index i = 0; i < 20; ++i)
    given.col(i).tail(4) = turn({1, 2, 3}, 0.5 * static_cast<double>(i)) * (i % 3 == 1 ? -1 : 1);
  const Points found = columns_of(path_through(space, given));
  for (Index i = 0; i + 1 < 20; ++i) CHECK(found.col(i).tail(4).dot(found.col(i + 1).tail(4)) > 0.9);
}

TEST_CASE("ompl columns: the length is OMPL's where OMPL has a length") {
  std::mt19937 random(5);
  for (const ob::StateSpacePtr& space :
       {ob::StateSpacePtr(square(3)), ob::StateSpacePtr(std::make_shared<ob::SO2StateSpace>())}) {
    const PlannerSpace information = open_space(space);
    const StateColumns columns(space);
    const auto sampler = information->allocStateSampler();
    ob::ScopedState<> a(space), b(space);
    for (int i = 0; i < 50; ++i) {
      sampler->sampleUniform(a.get());
      sampler->sampleUniform(b.get());
      Eigen::VectorXd from = columns.column(*a.get()), to = columns.column(*b.get());
      columns.unwrap(from, to);
      CHECK(move_cost(*columns.length(), from, to) == Approx(information->distance(a.get(), b.get())));
    }
  }
}

TEST_CASE("ompl columns: in compound spaces the length weighs parts as the space does, one at a time") {
  const StateColumns columns(planar_poses());
  const Eigen::Vector3d at(1, 2, 0.3);
  CHECK(move_cost(*columns.length(), at, at + Eigen::Vector3d(3, 4, 0)) == Approx(5));
  CHECK(move_cost(*columns.length(), at, at + Eigen::Vector3d(0, 0, 0.4)) == Approx(0.5 * 0.4));  // OMPL's weight
  CHECK(move_cost(*columns.length(), at, at + Eigen::Vector3d(3, 4, 0.4)) == Approx(std::hypot(5, 0.2)));
}

TEST_CASE("ompl columns: OMPL's distance is never more than they are steep") {
  std::mt19937 random(7);
  for (const ob::StateSpacePtr& space : {ob::StateSpacePtr(planar_poses()), ob::StateSpacePtr(poses())}) {
    const PlannerSpace information = open_space(space);
    const StateColumns columns(space);
    const auto sampler = information->allocStateSampler();
    ob::ScopedState<> a(space), b(space);
    for (int i = 0; i < 200; ++i) {
      sampler->sampleUniform(a.get());
      sampler->sampleUniformNear(b.get(), a.get(), 0.5);
      Eigen::VectorXd from = columns.column(*a.get()), to = columns.column(*b.get());
      columns.unwrap(from, to);
      CHECK(information->distance(a.get(), b.get()) <= columns.steepness() * (to - from).norm() * (1 + 1e-6) + 1e-7);
    }
  }
}

TEST_CASE("ompl columns: the domain of poses is a domain") {
  std::mt19937_64 engine(4);
  const auto near = [](std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    Eigen::VectorXd place = Eigen::VectorXd::NullaryExpr(7, [&] { return normal(random); });
    place.tail(4) *= (1 + 0.1 * normal(random)) / place.tail(4).norm();
    return place;
  };
  for (const Fault& fault : check_manifold(*StateColumns(poses()).domain(), near, engine))
    FAIL_CHECK(fault.name + ": " + fault.message);
}

TEST_CASE("ompl columns: what is none of these spaces is refused by its name") {
  const auto clock = std::make_shared<ob::TimeStateSpace>();
  CHECK_THROWS_AS(StateColumns(clock), InputError);
  CHECK_THROWS_WITH(StateColumns(clock), Catch::Contains("the space " + clock->getName() +
                                                         " is not R^n, SO(2), SO(3) or a compound of "
                                                         "them: leastcost has no coordinates for it"));
  const auto mixed = std::make_shared<ob::CompoundStateSpace>();
  mixed->addSubspace(square(), 1);
  mixed->addSubspace(std::make_shared<ob::DiscreteStateSpace>(0, 3), 1);
  CHECK_THROWS_AS(StateColumns(mixed), InputError);
  CHECK_THROWS_AS(StateColumns(nullptr), InputError);
  const PlannerSpace space = open_space(square());
  CHECK_THROWS_AS(StateColumns(space->getStateSpace()).path(space, Points::Zero(3, 4)), InputError);
}

TEST_CASE("ompl columns: a state that is no number, a quaternion of no length") {
  const PlannerSpace flat = open_space(square());
  PlannerPath path = path_through(flat, Points::Ones(2, 3));
  path.getState(1)->as<ob::RealVectorStateSpace::StateType>()->values[1] = std::nan("");
  CHECK_THROWS_AS(columns_of(path), InputError);
  CHECK_THROWS_WITH(columns_of(path), Catch::Contains("state 1 has a value that is not a number"));
  const PlannerSpace turning = open_space(poses());
  Points upright = Points::Zero(7, 2);
  upright.row(6).setOnes();
  PlannerPath turned = path_through(turning, upright);
  turned.getState(1)->as<ob::SE3StateSpace::StateType>()->rotation().w = 0;
  CHECK_THROWS_AS(columns_of(turned), InputError);
  CHECK_THROWS_WITH(columns_of(turned), Catch::Contains("state 1 has a quaternion of length 0"));
}

}  // namespace leastcost::test
