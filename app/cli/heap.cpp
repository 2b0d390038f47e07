// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/heap.hpp"

#include <cstdlib>  // says which C library it is

#if defined(__GLIBC__)

#include <malloc.h>
#include <unistd.h>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "problems/exact/large_pages.hpp"

namespace leastcost::app {

void prepare_heap() {
  constexpr int kFirstStep = 256 << 20, kStep = 4 << 20;  // bytes of addresses; memory follows as it is written
  constexpr int kLargestInHeap = 32 << 20;                // the most that glibc takes
  constexpr std::size_t kPage = 4096;
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, kLargestInHeap);
  mallopt(M_TOP_PAD, kFirstStep);
  // An allocation that does not fit yet takes the first step, which lasts to the end of the heap. Later steps are
  // small, as each is refused as a whole where the address space is limited; so may this one be.
  void* const first = std::malloc(1 << 20);
  mallopt(M_TOP_PAD, kStep);
  // Wraps around where the allocation is not in this heap.
  std::size_t length = reinterpret_cast<std::uintptr_t>(sbrk(0)) - reinterpret_cast<std::uintptr_t>(first);
  void* begin = first;
  if (first != nullptr && length <= std::size_t{2} * kFirstStep && std::align(kPage, kPage, begin, length) != nullptr)
    ask_for_large_pages(begin, length);
  std::free(first);
}

}  // namespace leastcost::app

#else

namespace leastcost::app {

void prepare_heap() {}

}  // namespace leastcost::app

#endif
