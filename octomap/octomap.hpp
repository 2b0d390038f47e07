// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Obstacles from OctoMap files, by component octomap; a library of its own, built where OctoMap is found.

#include <leastcost/octomap/octomap_obstacles.hpp>
