// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The solvers of our own. What this header reaches is public and installed; everything else in the folder is internal.

#include <leastcost/solvers/georce.hpp>
#include <leastcost/solvers/gradient_descent.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include <leastcost/solvers/string_method.hpp>
#include <leastcost/solvers/vfcs.hpp>
