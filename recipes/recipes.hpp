// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Which method fits which problem: what a run does when nothing is asked for, in C++ as in a configuration.

#include <leastcost/recipes/facts.hpp>
#include <leastcost/recipes/find_path.hpp>
#include <leastcost/recipes/look_elsewhere.hpp>
#include <leastcost/recipes/recommended.hpp>
