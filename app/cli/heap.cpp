// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/heap.hpp"

#include <cstdlib>  // says which C library it is

#if defined(__GLIBC__)

#include <malloc.h>
#include <unistd.h>
#include <cstdint>

#include "problems/exact/large_pages.hpp"

namespace leastcost::app {

void prepare_heap() {
  constexpr int kFirstStep = 256 << 20, kStep = 4 << 20;  // bytes of addresses; memory follows as it is written
  constexpr int kLargestInHeap = 32 << 20;                // the most that glibc takes
  constexpr std::uintptr_t kPage = 4096;
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, kLargestInHeap);
  mallopt(M_TOP_PAD, kFirstStep);
  // An allocation that does not fit yet takes the first step, which lasts to the end of the heap. Later steps are
  // small, as each is refused as a whole where the address space is limited; so may this one be.
  void* const first = std::malloc(1 << 20);
  mallopt(M_TOP_PAD, kStep);
  const auto begin = (reinterpret_cast<std::uintptr_t>(first) + kPage - 1) / kPage * kPage;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  if (first != nullptr && end > begin && end - begin <= std::uintptr_t{2} * kFirstStep)
    ask_for_large_pages(reinterpret_cast<void*>(begin), end - begin);
  std::free(first);
}

}  // namespace leastcost::app

#else

namespace leastcost::app {

void prepare_heap() {}

}  // namespace leastcost::app

#endif
