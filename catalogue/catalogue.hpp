// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Configurations: read one, change it in memory, solve it, write its files. What this header reaches is public and
/// installed; everything else in the folder is internal.

#include <leastcost/catalogue/output/results.hpp>
#include <leastcost/catalogue/registry/registry.hpp>
#include <leastcost/catalogue/run/run.hpp>
