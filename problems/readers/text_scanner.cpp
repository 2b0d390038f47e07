// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/text_scanner.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string found(std::string_view token) {
  return token.empty() ? std::string("the end of the line") : printable(token);
}

/// from_chars knows no plus sign.
std::string_view without_plus(std::string_view token) {
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
  return plus ? token.substr(1) : token;
}

/// Too large or too small are the same to from_chars. Too small is 0 for us, or the number that is left of it below the
/// least normal one; too large is infinite. strtod would read the decimal point of the host's locale.
double out_of_range(std::string_view digits) {
  std::istringstream in{std::string(digits)};
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;  // the largest number where it is too large
  return in.fail() && std::abs(value) >= 1 ? std::copysign(std::numeric_limits<double>::infinity(), value) : value;
}

}  // namespace

std::string printable(std::string_view token) {
  constexpr std::size_t kShown = 40;
  constexpr const char* kHex = "0123456789abcdef";
  std::string result = "'";
  for (const char c : token.substr(0, kShown)) {
    const unsigned byte = static_cast<unsigned char>(c);
    if (byte >= 32 && byte != 127) {
      result += c;
    } else {
      result += std::string("\\x") + kHex[byte / 16] + kHex[byte % 16];
    }
  }
  return result + (token.size() > kShown ? "...'" : "'");
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

TextScanner::TextScanner(std::string_view text, std::string file, Syntax syntax, const Deadline& deadline)
    : text_(text), file_(std::move(file)), syntax_(syntax), deadline_(deadline) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

std::size_t TextScanner::after_break(std::size_t i) const {
  if (i < text_.size() && text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n') return i + 2;
  return i < text_.size() ? i + 1 : i;
}

std::size_t TextScanner::next_line_offset() const {
  std::size_t i = at_;
  while (!at_break(i)) ++i;
  return after_break(i);
}

void TextScanner::skip_blanks() {
  while (at_ < text_.size()) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (joins_lines(at_)) {
      at_ = after_break(at_ + 1);
      ++line_;
    } else {
      return;
    }
  }
}

std::string_view TextScanner::token() {
  if (at_line_end()) return {};
  const std::size_t first = at_;
  while (!at_break(at_) && !is_blank(text_[at_]) && !joins_lines(at_)) ++at_;
  return text_.substr(first, at_ - first);
}

bool TextScanner::at_line_end() {
  skip_blanks();
  return at_break(at_) || (syntax_.comment != 0 && text_[at_] == syntax_.comment);
}

bool TextScanner::next_line() {
  look_at_clock(deadline_, static_cast<std::int64_t>(line_));
  if (line_ == 0) {
    ++line_;
    if (!at_line_end()) return true;
  }
  while (at_ < text_.size()) {
    while (!token().empty()) {
    }
    at_ = next_line_offset();
    ++line_;
    if (!at_line_end()) return true;
  }
  return false;
}

double TextScanner::number(const char* what) { return parse_number(token(), what); }
std::int64_t TextScanner::integer(const char* what) { return parse_integer(token(), what); }

double TextScanner::parse_number(std::string_view token, const char* what) const {
  const std::string_view digits = without_plus(token);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range && end == digits.data() + digits.size()) {
    value = out_of_range(digits);
  } else if (error != std::errc() || end != digits.data() + digits.size() || digits.empty()) {
    fail(std::string("expected ") + what + ", found " + found(token));
  }
  if (!std::isfinite(value)) fail(std::string("expected ") + what + " that is finite, found " + printable(token));
  return value;
}

std::int64_t TextScanner::parse_integer(std::string_view token, const char* what) const {
  const std::string_view digits = without_plus(token);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.empty()) {
    fail(std::string("expected ") + what + " (an integer), found " + found(token));
  }
  return value;
}

void TextScanner::expect_line_end(const char* after) {
  if (!at_line_end()) fail("unexpected " + printable(token()) + " after " + after);
}

void TextScanner::fail(const std::string& message) const { fail_at(line_, message); }

void TextScanner::fail_at(std::size_t line, const std::string& message) const {
  throw InputError(file_ + ":" + std::to_string(line) + ": " + message);
}

}  // namespace leastcost
