// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/words.hpp>

/// Catch2, version 2 (Debian 12: one header) or 3 (everybody else: catch_all.hpp). Tests are written for version 2;
/// what version 3 calls otherwise gets its old name back here.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#include <string>
using Catch::Approx;
namespace Catch {
inline auto Contains(const std::string& part) { return Matchers::ContainsSubstring(part); }
}  // namespace Catch
#else
#include <catch2/catch.hpp>
#endif

/// Enums are printed by their words.
template <leastcost::Choice Enum>
struct Catch::StringMaker<Enum> {
  static std::string convert(Enum value) { return std::string(leastcost::word_of(value)); }
};
