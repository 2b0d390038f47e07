// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Studies in a program: what `leastcost study` does, and no printing.
///
///     const leastcost::StudyResult result = leastcost::run_study("study.yaml", {}, {.output = "results/study"});
///     if (!result.complete_and_ok()) std::printf("%ld of %ld runs failed\n", result.failed, result.runs);

#include <leastcost/app/study/run_study.hpp>
