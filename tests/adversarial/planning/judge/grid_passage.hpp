// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/adversarial/planning/judge/scene.hpp"

namespace judge {

/// Whether a grid of so many nodes along the longest side confirms a way from source to target that keeps the
/// clearance: along its edges, all of whose points keep it. False says nothing.
bool grid_confirms(const Scene& scene, int nodes);

}  // namespace judge
