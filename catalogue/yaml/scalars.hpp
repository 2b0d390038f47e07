// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <leastcost/framework/base/options.hpp>
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// A value, or what is wrong in words that follow the name of the option: "must be a whole number (found 64.5)".
template <class T>
struct Parsed {
  std::optional<T> value;
  std::string fault;
};

/// Strict: YAML's own reading of numbers is not used. It takes 010 for 8, yes for true and cuts off what does not fit.
Parsed<bool> parse_bool(const ConfigNode& node);
Parsed<int> parse_int(const ConfigNode& node);
/// Decimal numbers. `infinite`: .inf and -.inf are values too. Never NaN.
Parsed<double> parse_double(const ConfigNode& node, bool infinite = false);
/// Any scalar, as written: a name may be 2024.
Parsed<std::string> parse_text(const ConfigNode& node);

/// "must be at least 1" when the value is outside the documented range; empty when inside.
std::string range_fault(double value, const FieldDoc& doc);
/// The range in words, "at least 1"; empty where everything is allowed.
std::string range_in_words(const FieldDoc& doc);

/// What a node is, for "(found ...)".
std::string found(const ConfigNode& node);

/// Shortest text that reads back as the same number, here and in readers of YAML 1.1 (1.0e-06: to those 1e-06 is text).
std::string number_text(double value);

}  // namespace leastcost
