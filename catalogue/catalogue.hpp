// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Configurations: read one, change it in memory, solve it, write its files.
///
///     leastcost::Run run = leastcost::load_run("slide.yaml", {{"path.points=200"}});
///     run.parts.problem.cost = std::make_shared<MyCost>();
///     leastcost::RunOutcome outcome = leastcost::solve(run);
///     leastcost::write_run(outcome, "results/slide");
///
/// Plug-ins of your own join them: catalogue/registry/register.hpp.
///
/// What this header reaches is public and installed; everything else in the folder is internal.

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/catalogue/pairs/solve_pairs.hpp>
#include <leastcost/catalogue/registry/register.hpp>
#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>
