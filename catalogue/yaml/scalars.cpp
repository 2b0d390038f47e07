// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/scalars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t count_digits(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  return static_cast<std::size_t>(end - text.begin());
}

std::string_view without_sign(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  return text;
}

bool is_whole(std::string_view text) {
  const std::string_view digits = without_sign(text);
  return !digits.empty() && count_digits(digits) == digits.size();
}

bool has_leading_zero(std::string_view text) {
  const std::string_view digits = without_sign(text);
  return digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]);
}

/// digits [. digits] [e digits], with at least one digit before the exponent.
bool is_decimal(std::string_view text) {
  std::string_view rest = without_sign(text);
  std::size_t mantissa = count_digits(rest);
  rest.remove_prefix(mantissa);
  if (!rest.empty() && rest[0] == '.') {
    rest.remove_prefix(1);
    const std::size_t fraction = count_digits(rest);
    mantissa += fraction;
    rest.remove_prefix(fraction);
  }
  if (mantissa == 0) return false;
  if (rest.empty()) return true;
  if (rest[0] != 'e' && rest[0] != 'E') return false;
  rest = without_sign(rest.substr(1));
  return !rest.empty() && count_digits(rest) == rest.size();
}

std::string_view for_from_chars(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  return text;
}

template <class T>
Parsed<T> fault(std::string text) {
  return {std::nullopt, std::move(text)};
}

}  // namespace

std::string found(const ConfigNode& node) {
  switch (node.kind) {
    case ConfigNode::Kind::nothing: return "found nothing";
    case ConfigNode::Kind::scalar:
      return node.quoted ? "found the text " + in_quotes(node.text) + " in quotes" : "found " + in_quotes(node.text);
    case ConfigNode::Kind::list: return "found a list";
    case ConfigNode::Kind::block: return "found a block of keys";
  }
  return "";
}

Parsed<bool> parse_bool(const ConfigNode& node) {
  if (node.is_scalar() && !node.quoted) {
    if (node.text == "true") return {true, ""};
    if (node.text == "false") return {false, ""};
  }
  return fault<bool>("must be true or false (" + found(node) + ")");
}

Parsed<int> parse_int(const ConfigNode& node) {
  if (node.is_scalar() && !node.quoted && !is_whole(node.text) && is_decimal(node.text))
    return fault<int>("must be a whole number in digits, without point and exponent (" + found(node) + ")");
  if (!node.is_scalar() || node.quoted || !is_whole(node.text))
    return fault<int>("must be a whole number (" + found(node) + ")");
  if (has_leading_zero(node.text))
    return fault<int>("must be a whole number without leading zeros (" + found(node) + ")");
  int value = 0;
  const std::string_view digits = for_from_chars(node.text);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc()) {
    return fault<int>(fmt::format("must be a whole number between {} and {} ({})", std::numeric_limits<int>::min(),
                                  std::numeric_limits<int>::max(), found(node)));
  }
  return {value, ""};
}

Parsed<double> parse_double(const ConfigNode& node, bool infinite) {
  const std::string& text = node.text;
  if (node.is_scalar() && !node.quoted && infinite) {
    if (text == ".inf" || text == "+.inf") return {std::numeric_limits<double>::infinity(), ""};
    if (text == "-.inf") return {-std::numeric_limits<double>::infinity(), ""};
  }
  if (!node.is_scalar() || node.quoted || !is_decimal(text)) {
    const char* const what = infinite ? "must be a number, .inf or -.inf (" : "must be a finite number (";
    return fault<double>(what + found(node) + ")");
  }
  if (has_leading_zero(text)) return fault<double>("must be a number without leading zeros (" + found(node) + ")");
  double value = 0;
  const std::string_view digits = for_from_chars(text);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || !std::isfinite(value))
    return fault<double>("must be a number that fits double precision (" + found(node) + ")");
  return {value, ""};
}

Parsed<std::string> parse_text(const ConfigNode& node) {
  if (node.is_scalar() && !node.text.empty()) return {node.text, ""};
  return fault<std::string>(node.is_scalar() ? "must not be empty" : "must be text (" + found(node) + ")");
}

std::string range_in_words(const FieldDoc& doc) {
  const bool below = std::isfinite(doc.minimum), above = std::isfinite(doc.maximum);
  const std::string least = (doc.exclusive_minimum ? "greater than " : "at least ") + number_text(doc.minimum);
  const std::string most = "at most " + number_text(doc.maximum);
  if (below && above) return least + " and " + most;
  return below ? least : above ? most : "";
}

std::string range_fault(double value, const FieldDoc& doc) {
  const bool low = doc.exclusive_minimum ? value <= doc.minimum : value < doc.minimum;
  if (!low && value <= doc.maximum) return "";
  return "must be " + range_in_words(doc);
}

std::string number_text(double value) {
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

}  // namespace leastcost
