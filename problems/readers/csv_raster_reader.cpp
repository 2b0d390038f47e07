// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/raster_reader.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

/// The lines of a table, field by field. A comma or a semicolon separates fields, which may be empty; without either
/// blanks do.
class CsvRows {
 public:
  CsvRows(std::string_view text, const std::string& file) : text_(text), scanner_("", file, {}) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // spreadsheets write it
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }

  /// The next line that is not empty; false at the end.
  bool next(std::vector<double>& row) {
    row.clear();
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      const std::string_view line = trimmed(text_.substr(at_, end - at_));
      at_ = end + 1;
      ++line_;
      if (line.empty() || line[0] == '#') continue;
      split(line, row);
      return true;
    }
    return false;
  }

  [[noreturn]] void fail(const std::string& message) const { scanner_.fail_at(line_, message); }

 private:
  void split(std::string_view line, std::vector<double>& row) const {
    const char separator = line.find(',') != std::string_view::npos   ? ','
                           : line.find(';') != std::string_view::npos ? ';'
                                                                      : ' ';
    for (std::size_t begin = 0; begin <= line.size();) {
      std::size_t end = separator == ' ' ? line.find_first_of(" \t", begin) : line.find(separator, begin);
      end = std::min(end, line.size());
      row.push_back(value(trimmed(line.substr(begin, end - begin))));
      begin = end + 1;
      if (separator == ' ') begin = std::min(line.find_first_not_of(" \t", end), line.size() + 1);
    }
  }

  double value(std::string_view field) const {
    if (field.empty() || is_no_value(field)) return std::numeric_limits<double>::quiet_NaN();
    try {
      return scanner_.parse_number(field, "a number");
    } catch (const InputError&) {  // the scanner does not know the line
      fail("expected a number or an empty field, found " + printable(field) +
           "; a raster is a table of numbers without a header");
    }
  }

  std::string_view text_;
  TextScanner scanner_;
  std::size_t at_ = 0, line_ = 0;
};

}  // namespace

RasterFile read_csv_raster(std::string_view text, const std::string& file) {
  RasterFile out;
  RasterGrid& raster = out.raster;
  raster.source = file;
  CsvRows lines(text, file);
  std::vector<double> row, top_down;
  while (lines.next(row)) {
    if (raster.rows == 0) raster.columns = static_cast<int>(row.size());
    if (row.size() != static_cast<std::size_t>(raster.columns))
      lines.fail(std::to_string(row.size()) + " values, but the rows before have " + std::to_string(raster.columns));
    check_raster_size(++raster.rows, raster.columns, file);
    top_down.insert(top_down.end(), row.begin(), row.end());
  }
  if (raster.rows == 0) throw InputError(file + ": has no values");
  raster.values.reserve(top_down.size());
  for (int r = raster.rows - 1; r >= 0; --r) {
    const auto begin = top_down.begin() + static_cast<std::ptrdiff_t>(raster.index(r, 0));
    raster.values.insert(raster.values.end(), begin, begin + raster.columns);
  }
  return out;
}

}  // namespace leastcost
