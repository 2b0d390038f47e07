// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace leastcost::test {

#if defined(__has_feature)  // Clang
#if __has_feature(address_sanitizer)
#define LEASTCOST_TEST_SANITIZED
#endif
#elif defined(__SANITIZE_ADDRESS__)  // GCC
#define LEASTCOST_TEST_SANITIZED
#endif
#ifdef LEASTCOST_TEST_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Whether .ci/nightly runs: whole sweeps. .ci/run takes a share of them.
inline bool nightly() {
  return std::getenv("LEASTCOST_NIGHTLY") != nullptr;  // NOLINT(concurrency-mt-unsafe): tests do not change it
}

/// How often a test that takes its time repeats a trial: in .ci/nightly `count` times, otherwise half of that. Under a
/// sanitizer, where one takes twenty to a hundred times as long and what the code does matters more than what comes
/// out, an eighth.
inline int trials(int count) {
  if (kSanitized) return std::max(1, count / 8);
  return nightly() ? count : std::max(1, count / 2);
}

/// What .ci/run takes of a long list: every `step`-th, beginning with the first.
template <class T>
std::vector<T> share(const std::vector<T>& all, std::size_t step) {
  if (nightly()) return all;
  std::vector<T> some;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

}  // namespace leastcost::test
