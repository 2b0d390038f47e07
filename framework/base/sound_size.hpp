// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {

/// Lengths between which products of four of them, and their inverses, are numbers in double precision.
constexpr double kLeastSize = 1e-75, kGreatestSize = 1e75;

/// Throws InputError, which begins with `what`, for a size of data beyond these lengths: squares would be 0 or
/// overflow.
inline void check_sound_size(const std::string& what, double size) {
  if (size >= kLeastSize && size <= kGreatestSize) return;
  const bool small = size < kLeastSize;
  throw InputError(what + " is " + short_number(size) + ", " + (small ? "below 1e-75" : "beyond 1e75") +
                   ": products of such lengths " + (small ? "vanish" : "overflow") +
                   " in double precision; give coordinates in sensible units");
}

}  // namespace leastcost
