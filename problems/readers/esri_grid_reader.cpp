// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/file_content.hpp"
#include "problems/readers/raster_reader.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

bool begins_number(std::string_view token) {
  return !token.empty() && token.find_first_of("0123456789") != std::string_view::npos &&
         std::string_view("+-.0123456789").find(token[0]) != std::string_view::npos;
}

double value_of(const TextScanner& scanner, std::string_view token) {
  if (is_no_value(token)) return std::numeric_limits<double>::quiet_NaN();
  return scanner.parse_number(token, "a value of the grid");
}

/// The lines of key and value at the top of the file.
class GridHeader {
 public:
  /// Leaves the scanner behind the first value of the grid, which is returned.
  std::string_view read(TextScanner& scanner) {
    while (scanner.next_line()) {
      const std::string_view token = scanner.token();
      if (begins_number(token) || is_no_value(token)) return token;
      const std::string key = lower_case(std::string(token));
      if (kKeys.find(" " + key + " ") == std::string_view::npos)
        scanner.fail("expected a key of an ESRI ASCII grid (" + std::string(kKeys.substr(1, kKeys.size() - 2)) +
                     ") or a value, found " + printable(token));
      if (values_.count(key) > 0) scanner.fail("a second " + key);
      values_[key] = {key == "nodata_value" ? value_of(scanner, scanner.token()) : scanner.number("a number"),
                      scanner.line()};
      scanner.expect_line_end("the value of the key");
    }
    scanner.fail("the file ends before the values of the grid");
  }

  std::optional<double> find(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::nullopt : std::optional(found->second.value);
  }
  double need(const TextScanner& scanner, const std::string& key) const {
    const std::optional<double> value = find(key);
    if (!value) scanner.fail("the header has no " + key);
    return *value;
  }
  std::int64_t count(const TextScanner& scanner, const std::string& key) const {
    const double value = need(scanner, key);
    constexpr double kMost = static_cast<double>(RasterGrid::kMostCells);
    if (!(value >= 1 && value <= kMost) || value != static_cast<double>(static_cast<std::int64_t>(value)))
      scanner.fail_at(values_.at(key).line,
                      key + " must be a whole number from 1 to " + std::to_string(RasterGrid::kMostCells));
    return static_cast<std::int64_t>(value);
  }
  double length(const TextScanner& scanner, const std::string& key) const {
    const double value = need(scanner, key);
    if (!(value > 0)) scanner.fail_at(values_.at(key).line, key + " must be greater than 0");
    return value;
  }

 private:
  static constexpr std::string_view kKeys =
      " ncols nrows xllcorner xllcenter yllcorner yllcenter cellsize dx dy nodata_value ";
  struct Value {
    double value = 0;
    std::size_t line = 0;
  };
  std::map<std::string, Value> values_;
};

/// The lower left corner along one axis: given as such, or by the middle of the cell there.
double corner(const TextScanner& scanner, const GridHeader& header, const std::string& axis, double cell) {
  const std::optional<double> at_corner = header.find(axis + "llcorner"), at_center = header.find(axis + "llcenter");
  if (at_corner && at_center) scanner.fail("the header has both " + axis + "llcorner and " + axis + "llcenter");
  if (!at_corner && !at_center) scanner.fail("the header has neither " + axis + "llcorner nor " + axis + "llcenter");
  return at_corner ? *at_corner : *at_center - cell / 2;
}

}  // namespace

RasterFile read_esri_grid(std::string_view text, const std::string& file) {
  TextScanner scanner(text, file, {.comment = '\0'});
  GridHeader header;
  std::string_view token = header.read(scanner);
  RasterFile out;
  RasterGrid& raster = out.raster;
  const std::int64_t rows = header.count(scanner, "nrows"), columns = header.count(scanner, "ncols");
  check_raster_size(rows, columns, file);
  raster.rows = static_cast<int>(rows);
  raster.columns = static_cast<int>(columns);
  raster.source = file;
  const bool square = header.find("cellsize").has_value();
  // Not by Eigen's comma, which ends the program where one of its values is an error that is thrown.
  raster.cell = {header.length(scanner, square ? "cellsize" : "dx"),
                 header.length(scanner, square ? "cellsize" : "dy")};
  raster.corner = {corner(scanner, header, "x", raster.cell[0]), corner(scanner, header, "y", raster.cell[1])};
  out.nodata = header.find("nodata_value");
  const std::int64_t cells = rows * columns;
  if (static_cast<std::int64_t>(scanner.bytes_left()) + 1 < 2 * (cells - 1))  // before memory is taken
    scanner.fail("a grid of " + std::to_string(rows) + " x " + std::to_string(columns) +
                 " values, but the file has only " + std::to_string(scanner.bytes_left()) + " bytes left");
  raster.values.resize(static_cast<std::size_t>(cells));
  for (int row = raster.rows - 1; row >= 0; --row)
    for (int column = 0; column < raster.columns; ++column) {  // lines need not be rows
      while (token.empty()) {
        if (scanner.at_line_end() && !scanner.next_line())
          scanner.fail("the file ends after " + std::to_string((raster.rows - 1 - row) * columns + column) + " of " +
                       std::to_string(cells) + " values");
        token = scanner.token();
      }
      raster.values[raster.index(row, column)] = value_of(scanner, token);
      token = scanner.token();
    }
  if (!token.empty() || scanner.next_line())
    scanner.fail("more values than the header says (" + std::to_string(cells) + ")");
  return out;
}

bool is_no_value(std::string_view token) {
  if (!token.empty() && (token[0] == '-' || token[0] == '+')) token.remove_prefix(1);
  if (token.empty()) return false;
  if (token.find('#') != std::string_view::npos) return token.substr(0, 3) == "1.#";  // as old C libraries write it
  if (token[0] >= '0' && token[0] <= '9') return false;
  static constexpr std::array<std::string_view, 7> kWords = {"nan", "inf", "infinity", "na", "n/a", "null", "*"};
  const std::string word = token.size() <= 8 ? lower_case(std::string(token)) : "";
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

void check_raster_size(std::int64_t rows, std::int64_t columns, const std::string& place) {
  const auto fits = [](std::int64_t n) { return n >= 1 && n <= RasterGrid::kMostCells; };
  if (fits(rows) && fits(columns) && rows * columns <= RasterGrid::kMostCells) return;
  throw InputError(place + ": a raster of " + std::to_string(rows) + " x " + std::to_string(columns) +
                   " cells; at least one and at most " + std::to_string(RasterGrid::kMostCells) + " can be read");
}

}  // namespace leastcost
