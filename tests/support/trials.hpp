// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace leastcost::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// How often a test that takes its time repeats a trial. Under a sanitizer, where one takes twenty to a hundred times
/// as long and what the code does matters more than what comes out, an eighth of that.
constexpr int trials(int count) { return kSanitized ? std::max(1, count / 8) : count; }

/// Whether .ci/nightly runs: whole sweeps. .ci/run takes a share of them.
inline bool nightly() {
  return std::getenv("LEASTCOST_NIGHTLY") != nullptr;  // NOLINT(concurrency-mt-unsafe): tests do not change it
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
