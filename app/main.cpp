// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/app/app.hpp>

int main(int argc, char** argv) { return leastcost::run_program(argc, argv); }
