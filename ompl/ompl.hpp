// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// For programs that plan with OMPL: its plans polished, our domains as its constraints, our costs as its objectives,
/// its planners as makers of first paths.

#include <leastcost/ompl/constraint.hpp>
#include <leastcost/ompl/objective.hpp>
#include <leastcost/ompl/ompl_initializer.hpp>
#include <leastcost/ompl/polish.hpp>
#include <leastcost/ompl/pose_walls.hpp>
#include <leastcost/ompl/state_columns.hpp>
