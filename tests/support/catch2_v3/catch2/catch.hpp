// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// The one header of Catch2 2, for a build with Catch2 3; on the include path only then.
#include "tests/support/catch.hpp"
