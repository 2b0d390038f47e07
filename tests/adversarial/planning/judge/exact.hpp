// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tests/adversarial/planning/judge/scene.hpp"

namespace judge {

struct Touch {
  std::size_t segment = 0, thing = 0;
};

/// Whether some point of the straight segment from a to b is nearer to the thing than radius + clearance - tolerance.
/// Decided in rational numbers for the doubles as they are, so that there is no rounding in it at all.
bool comes_nearer(const Thing& thing, double clearance, double tolerance, const Place& a, const Place& b);

/// The first segment of a polyline that does, if one does. What a float says is far away (by far more than its
/// rounding) is not asked exactly.
std::optional<Touch> first_touch(const Scene& scene, const std::vector<Place>& path, double tolerance);

/// Least distance of a segment from the core of a thing, to rounding of doubles; 0 within it.
double about_distance(const Thing& thing, const Place& a, const Place& b);

}  // namespace judge
