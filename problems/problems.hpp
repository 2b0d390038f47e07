// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Kernels, costs, manifolds, initializers, post-processors and readers. What this header reaches is public and
/// installed; everything else in the folder is internal.

#include <leastcost/problems/bounds.hpp>
#include <leastcost/problems/core.hpp>
#include <leastcost/problems/mesh.hpp>
#include <leastcost/problems/planning.hpp>
