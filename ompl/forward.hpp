// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// The classes of OMPL that stand in our interface by name alone: its headers are included by who uses what they
/// declare, and no installed header of ours needs them.
namespace ompl::base {
class Constraint;
class OptimizationObjective;
class SpaceInformation;
class State;
class StateSpace;
}  // namespace ompl::base

namespace ompl::geometric {
class PathGeometric;
}  // namespace ompl::geometric
