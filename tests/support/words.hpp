// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include <leastcost/framework/base/options.hpp>

// Choices and forms by their words, for tests that go through a list of them.
namespace leastcost::test {

template <Choice Enum>
Enum value_of(std::string_view word) {
  for (const Word<Enum>& w : words(Enum{}))
    if (w.word == word) return w.value;
  throw std::invalid_argument("no such choice: " + std::string(word));
}

template <class Variant, std::size_t I = 0>
Variant form(std::string_view type) {
  if constexpr (I == std::variant_size_v<Variant>) {
    throw std::invalid_argument("no such form: " + std::string(type));
  } else {
    if (std::variant_alternative_t<I, Variant>::kType == type) return Variant(std::in_place_index<I>);
    return form<Variant, I + 1>(type);
  }
}

/// The type of the form that a variant holds.
template <class Variant>
std::string type_of(const Variant& value) {
  return std::visit([](const auto& form) { return std::string(form.kType); }, value);
}

}  // namespace leastcost::test
