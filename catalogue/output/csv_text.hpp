// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leastcost {

/// RFC 4180 records of a text, with the line on which each begins.
struct CsvRecord {
  int line = 0;  ///< from 1
  std::vector<std::string> fields;
};
/// Line breaks may be \n or \r\n; empty lines are skipped. Throws InputError where a quote is never closed.
std::vector<CsvRecord> csv_records(std::string_view text, const std::string& name);

/// One field, in quotes where it needs them.
std::string csv_field(std::string_view text);

/// The same for a text of a user's, which a spreadsheet must not take for a formula: one that begins with =, +, -, @, a
/// tab or a line break, and is no number, gets an apostrophe before it; so does one that begins with an apostrophe.
std::string csv_text_field(std::string_view text);
/// What csv_text_field() was given.
std::string csv_text(const std::string& field);

/// 17 digits; nan, inf, -inf.
std::string csv_number(double value);
/// The whole text as a number, or nothing.
std::optional<double> csv_double(const std::string& text);
std::optional<long> csv_long(const std::string& text);

}  // namespace leastcost
