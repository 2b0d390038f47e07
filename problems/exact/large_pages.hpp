// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace leastcost {

/// A wish: nothing is lost where the system does not grant it.
void ask_for_large_pages(void* place, std::size_t bytes);

/// Memory of arrays that grow to many megabytes and are written once: asked for in pages of two megabytes where the
/// system has them, because each page costs a fault when it is first touched. Without them it is usual memory.
template <class T>
struct LargePages {
  using value_type = T;
  static constexpr std::size_t kPage = std::size_t{1} << 21;  // bytes; what is smaller stays in usual pages

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}  // NOLINT(google-explicit-constructor): as an allocator has to, for other types

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kPage) return static_cast<T*>(::operator new(bytes));
    void* const place = ::operator new(bytes, std::align_val_t(kPage));
    ask_for_large_pages(place, bytes);
    return static_cast<T*>(place);
  }
  void deallocate(T* place, std::size_t count) {
    if (count * sizeof(T) < kPage) {
      ::operator delete(place);
    } else {
      ::operator delete(place, std::align_val_t(kPage));
    }
  }
  template <class U>
  bool operator==(const LargePages<U>&) const {
    return true;
  }
};

/// A vector in such memory.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace leastcost
