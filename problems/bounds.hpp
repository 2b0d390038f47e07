// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The library leastcost::bounds: lower bounds of the cost of all paths in a box.

#include <leastcost/problems/bracket/search/bracket.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
