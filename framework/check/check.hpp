// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// For authors of costs and manifolds: what a contract asks for, measured at random points.
#include <leastcost/framework/check/check_cost.hpp>
#include <leastcost/framework/check/check_manifold.hpp>
