// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <span>
#include <string_view>
#include <type_traits>

namespace leastcost {

/// A value of an enum and its word in configurations, results and messages.
template <class Enum>
struct Word {
  Enum value;             ///< a value of the enum
  std::string_view word;  ///< its word
};

/// Every value of a choice once, in the order in which people read them.
template <class Enum>
using Words = std::span<const Word<Enum>>;

/// An enum with words: `Words<Rule> words(Rule)` stands beside it. The argument only says which enum is meant.
template <class Enum>
concept Choice = std::is_enum_v<Enum> && requires(Enum e) {
  { words(e) } -> std::same_as<Words<Enum>>;
};

/// The word of a value, ended by a null; empty for a number that is none of them.
template <Choice Enum>
std::string_view word_of(Enum value) {
  for (const Word<Enum>& w : words(value))
    if (w.value == value) return w.word;
  return "";
}

}  // namespace leastcost
