// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Reports and figures in a program, made from the files of a finished run or study.
///
///     leastcost::write_run(outcome, "results/slide");
///     leastcost::write_report("results/slide");                        // results/slide/report.html
///     leastcost::write_figure("results/slide", "slide.pdf", {.width = "84mm"});

#include <leastcost/app/figure/write_figure.hpp>
#include <leastcost/app/report/report.hpp>
