// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>

#include <leastcost/framework/base/options.hpp>
#include "tests/support/catch.hpp"

// What options promise about their choices: a misspelt one does not compile, and every value has one word.
namespace leastcost::test {

/// Whether a text or a number is taken for a value of a member: then a misspelt word compiles.
template <class Member>
inline constexpr bool kTakesWords =
    std::is_assignable_v<Member&, const char*> || std::is_assignable_v<Member&, std::string> ||
    std::is_assignable_v<Member&, int> || std::is_constructible_v<Member, const char*> ||
    std::is_constructible_v<Member, std::string>;

/// The words of an enum whose values are 0 .. last.
template <Choice Enum>
void check_words(Enum last) {
  const auto count = static_cast<std::size_t>(last) + 1;
  CHECK(words(Enum{}).size() == count);
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < count; ++i) seen.insert(word_of(static_cast<Enum>(i)));
  CHECK(seen.size() == count);
  CHECK(seen.count("") == 0);
}

}  // namespace leastcost::test
