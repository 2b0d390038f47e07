// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/value_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include "catalogue/yaml/scalars.hpp"

namespace leastcost {
namespace {

constexpr int kDeepestValue = 50;  // the deepest configuration has eight levels

std::string text_of(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  return number_text(value);
}

/// Reads one value and what is in it.
class ValueReader {
 public:
  explicit ValueReader(Diagnostics& errors) : errors_(errors) {}

  ConfigNode read(const ConfigValue& value, const std::string& subscript, int depth) {
    ConfigNode node;
    if (depth > kDeepestValue) {
      errors_.error({0, 0, 1, subscript}, fmt::format("lies below more than {} others", kDeepestValue));
    } else if (const auto* list = std::get_if<ConfigValue::List>(&value.value)) {
      node = read_list(*list, subscript, depth);
    } else if (const auto* block = std::get_if<ConfigValue::Block>(&value.value)) {
      node = read_block(*block, subscript, depth);
    } else {
      node = read_scalar(value);
    }
    node.place = {0, 0, 1, subscript};
    return node;
  }

 private:
  static ConfigNode read_scalar(const ConfigValue& value) {
    if (const auto* on = std::get_if<bool>(&value.value)) return scalar_node(*on ? "true" : "false");
    if (const auto* whole = std::get_if<std::int64_t>(&value.value)) return scalar_node(std::to_string(*whole));
    if (const auto* number = std::get_if<double>(&value.value)) return scalar_node(text_of(*number));
    if (const auto* text = std::get_if<std::string>(&value.value)) return scalar_node(*text, true);
    return {};
  }

  ConfigNode read_list(const ConfigValue::List& list, const std::string& subscript, int depth) {
    ConfigNode node;
    node.kind = ConfigNode::Kind::list;
    node.items.reserve(list.size());
    for (std::size_t i = 0; i < list.size(); ++i)
      node.items.push_back(read(list[i], fmt::format("{}[{}]", subscript, i), depth + 1));
    return node;
  }

  ConfigNode read_block(const ConfigValue::Block& block, const std::string& subscript, int depth) {
    ConfigNode node;
    node.kind = ConfigNode::Kind::block;
    for (const ConfigEntryValue& entry : block) {
      const std::string inner = fmt::format("{}['{}']", subscript, entry.key);
      if (node.find(entry.key) != nullptr)
        errors_.error({0, 0, 1, inner}, fmt::format("duplicate key {}", in_quotes(entry.key)));
      else
        node.entries.push_back({entry.key, {0, 0, 1, inner}, read(entry.value, inner, depth + 1)});
    }
    return node;
  }

  Diagnostics& errors_;
};

}  // namespace

ConfigNode read_value(const ConfigValue& value, const std::string& name, Diagnostics& errors) {
  return ValueReader(errors).read(value, name, 0);
}

}  // namespace leastcost
