// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// std::bit_cast for the standard library of clang 14, which is that of Debian's Emscripten and has none yet.
#include <bit>
#include <version>
#ifndef __cpp_lib_bit_cast
#include <cstring>
namespace std {
template <class To, class From>
To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  memcpy(&to, &from, sizeof(to));
  return to;
}
}  // namespace std
#endif
