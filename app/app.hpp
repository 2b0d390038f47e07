// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The command line as a library call, for programs with plug-ins of their own (examples/own_program):
///
///     int main(int argc, char** argv) {
///       leastcost::register_solver<GaussNewton>("gauss_newton", "Gauss-Newton steps on the chain.");
///       return leastcost::run_program(argc, argv);
///     }

#include <leastcost/catalogue/registry/register.hpp>

namespace leastcost {

/// The whole program `leastcost`: parses the arguments (argv[0] is the name that help texts use), runs the command,
/// writes to standard output and error, and returns the exit code. Plug-ins that were registered before are in runs,
/// studies, `list`, `describe`, the schema and completion. Never throws. Changes what SIGPIPE and SIGXFSZ do, and while
/// a run goes on SIGINT and SIGTERM, and how malloc() takes memory from the system, in the whole process: call it once,
/// from the main thread.
int run_program(int argc, char** argv);

}  // namespace leastcost
