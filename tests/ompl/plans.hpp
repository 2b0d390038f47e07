// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <utility>

#include <leastcost/ompl/ompl.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/moving_discs.hpp"

/// Spaces, and paths in them that were made by hand.
namespace leastcost::test {

using PlannerSpace = std::shared_ptr<ompl::base::SpaceInformation>;
using PlannerPath = ompl::geometric::PathGeometric;

inline std::shared_ptr<ompl::base::RealVectorStateSpace> square(unsigned dimension = 2, double low = 0,
                                                                double high = 10) {
  auto space = std::make_shared<ompl::base::RealVectorStateSpace>(dimension);
  space->setBounds(low, high);
  return space;
}

inline std::shared_ptr<ompl::base::SE2StateSpace> planar_poses() {
  auto space = std::make_shared<ompl::base::SE2StateSpace>();
  ompl::base::RealVectorBounds bounds(2);
  bounds.setLow(-10);
  bounds.setHigh(10);
  space->setBounds(bounds);
  return space;
}

inline std::shared_ptr<ompl::base::SE3StateSpace> poses() {
  auto space = std::make_shared<ompl::base::SE3StateSpace>();
  ompl::base::RealVectorBounds bounds(3);
  bounds.setLow(-10);
  bounds.setHigh(10);
  space->setBounds(bounds);
  return space;
}

/// Everything is free.
inline PlannerSpace open_space(ompl::base::StateSpacePtr space) {
  auto information = std::make_shared<ompl::base::SpaceInformation>(std::move(space));
  information->setStateValidityChecker([](const ompl::base::State*) { return true; });
  information->setup();
  return information;
}

/// The checker of a planner among discs, which knows distances.
class AmongDiscs final : public ompl::base::StateValidityChecker {
 public:
  AmongDiscs(const PlannerSpace& space, Discs discs)
      : ompl::base::StateValidityChecker(space), columns_(space->getStateSpace()), discs_(std::move(discs)) {}
  bool isValid(const ompl::base::State* state) const override { return clearance(state) >= 0; }
  double clearance(const ompl::base::State* state) const override {
    const Points place = columns_.column(*state);
    double least = std::numeric_limits<double>::infinity();
    for (const Disc& disc : discs_) least = std::min(least, std::hypot(place(0) - disc.x, place(1) - disc.y) - disc.r);
    return least;
  }

 private:
  StateColumns columns_;
  Discs discs_;
};

inline PlannerSpace among(ompl::base::StateSpacePtr space, Discs discs) {
  auto information = std::make_shared<ompl::base::SpaceInformation>(std::move(space));
  information->setStateValidityChecker(std::make_shared<AmongDiscs>(information, std::move(discs)));
  information->setStateValidityCheckingResolution(0.001);
  information->setup();
  return information;
}

inline PlannerPath path_through(const PlannerSpace& space, const Points& columns) {
  return *StateColumns(space->getStateSpace()).path(space, columns);
}

inline Points columns_of(const PlannerPath& path) {
  return StateColumns(path.getSpaceInformation()->getStateSpace()).columns(path);
}

}  // namespace leastcost::test
