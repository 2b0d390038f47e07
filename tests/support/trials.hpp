// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace leastcost::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// How often a test that takes its time repeats a trial. Under a sanitizer, where one takes twenty to a hundred times
/// as long and what the code does matters more than what comes out, an eighth of that.
constexpr int trials(int count) { return kSanitized ? std::max(1, count / 8) : count; }

}  // namespace leastcost::test
