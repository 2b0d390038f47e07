// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "tests/adversarial/planning/judge/scene.hpp"

namespace judge {

/// The length of the shortest path among discs that are larger by the clearance, in the plane: over the graph of their
/// common tangents, those from the ends, and the arcs between them; exact to rounding (in long double). Nothing where
/// there is no way. Throws std::runtime_error for anything but discs in the plane.
std::optional<double> shortest_among_discs(const Scene& scene);

}  // namespace judge
