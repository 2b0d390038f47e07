// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A libFuzzer program for the target whose name is LEASTCOST_FUZZ_TARGET.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const leastcost::fuzz::Target* const target = [] {
    for (const leastcost::fuzz::Target& t : leastcost::fuzz::targets())
      if (t.name == LEASTCOST_FUZZ_TARGET) return &t;
    std::abort();
  }();
  leastcost::fuzz::ask(*target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
