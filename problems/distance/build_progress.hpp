// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>

namespace leastcost {

/// Told how far the making of a large object is: the part of the present phase that is done, 0 to 1, and the phase in
/// words. It may throw to stop; the exception reaches whoever asked for the object. May be empty.
using BuildProgress = std::function<void(double part, std::string_view phase)>;

/// Calls it where there is one.
inline void report(const BuildProgress& progress, double part, std::string_view phase) {
  if (progress) progress(part, phase);
}

}  // namespace leastcost
