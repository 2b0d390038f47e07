// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace leastcost {

struct ConfigEntryValue;

/// A configuration, or a part of one, as values in memory: what a YAML file has as text. A text is never a number.
struct ConfigValue {
  using List = std::vector<ConfigValue>;
  using Block = std::vector<ConfigEntryValue>;  ///< keys are unique
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Block>;

  ConfigValue() = default;
  // NOLINTBEGIN(google-explicit-constructor): a value is written as it is, {"points", 40}
  ConfigValue(bool given);
  ConfigValue(int given);
  ConfigValue(std::int64_t given);
  ConfigValue(double given);
  ConfigValue(const char* text);
  ConfigValue(std::string text);
  ConfigValue(List list);
  ConfigValue(Block block);
  // NOLINTEND(google-explicit-constructor)

  Value value;  ///< nothing: a key without a value
};

/// A key of a block, with its value.
struct ConfigEntryValue {
  std::string key;    ///< name of the option
  ConfigValue value;  ///< what it is set to
};

// Here, as a block is complete only now.
inline ConfigValue::ConfigValue(bool given) : value(given) {}
inline ConfigValue::ConfigValue(int given) : value(std::int64_t{given}) {}
inline ConfigValue::ConfigValue(std::int64_t given) : value(given) {}
inline ConfigValue::ConfigValue(double given) : value(given) {}
inline ConfigValue::ConfigValue(const char* text) : value(std::string(text)) {}
inline ConfigValue::ConfigValue(std::string text) : value(std::move(text)) {}
inline ConfigValue::ConfigValue(List list) : value(std::move(list)) {}
inline ConfigValue::ConfigValue(Block block) : value(std::move(block)) {}

}  // namespace leastcost
