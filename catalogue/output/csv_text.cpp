// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/csv_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

/// Walks through the characters of a CSV text.
class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  std::vector<CsvRecord> read() {
    std::vector<CsvRecord> records;
    while (at_ < text_.size()) {
      CsvRecord record{line_, {}};
      read_record(record);
      if (record.fields.size() > 1 || !record.fields[0].empty()) records.push_back(std::move(record));
    }
    return records;
  }

 private:
  void read_record(CsvRecord& record) {
    for (;;) {
      record.fields.push_back(read_field());
      if (at_ >= text_.size()) return;
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c != ',') return;
    }
  }

  std::string read_field() {
    if (at_ < text_.size() && text_[at_] == '"') return read_quoted();
    const std::size_t start = at_;
    at_ = std::min(text_.find_first_of(",\n", at_), text_.size());
    std::string field(text_.substr(start, at_ - start));
    const bool ends_line = at_ >= text_.size() || text_[at_] == '\n';
    if (ends_line && !field.empty() && field.back() == '\r') field.pop_back();
    return field;
  }

  std::string read_quoted() {
    const int first_line = line_;
    std::string field;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') ++line_;
      if (text_[at_] != '"') {
        field += text_[at_];
      } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
        field += text_[++at_];
      } else {
        at_ = std::min(text_.find_first_of(",\n", at_), text_.size());
        return field;
      }
    }
    throw InputError(name_ + ":" + std::to_string(first_line) + ": a quote is never closed");
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

template <class T>
std::optional<T> number_from(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

}  // namespace

std::vector<CsvRecord> csv_records(std::string_view text, const std::string& name) {
  return CsvReader(text, name).read();
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string csv_text_field(std::string_view text) {
  constexpr std::string_view kDangerous = "=+-@\t\r\n'";
  const bool dangerous = !text.empty() && kDangerous.find(text.front()) != std::string_view::npos;
  const bool signed_up = !text.empty() && text.front() == '+';
  if (!dangerous || csv_double(std::string(text.substr(signed_up ? 1 : 0)))) return csv_field(text);
  return csv_field("'" + std::string(text));
}

std::string csv_text(const std::string& field) {
  return field.size() > 1 && field.front() == '\'' ? field.substr(1) : field;
}

std::string csv_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.17g", value);
  return {text.data(), static_cast<std::size_t>(length)};
}

std::optional<double> csv_double(const std::string& text) {
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  return number_from<double>(text);
}

std::optional<long> csv_long(const std::string& text) { return number_from<long>(text); }

}  // namespace leastcost
