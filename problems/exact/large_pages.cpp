// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/large_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace leastcost {

void ask_for_large_pages([[maybe_unused]] void* place, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  madvise(place, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace leastcost
