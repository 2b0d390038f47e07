// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/occupancy_reader.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

constexpr std::string_view kFree = ".GS", kBlocked = "@OTW";

/// The line "word value" that has to come next.
void expect_word(TextScanner& scanner, std::string_view word) {
  if (!scanner.next_line()) scanner.fail("the file ends before the line '" + std::string(word) + "'");
  const std::string_view found = scanner.token();
  if (found != word) scanner.fail("expected '" + std::string(word) + "', found " + printable(found));
}

std::int64_t size_line(TextScanner& scanner, std::string_view word) {
  expect_word(scanner, word);
  const std::int64_t size = scanner.integer("a number of cells");
  scanner.expect_line_end("the number of cells");
  return size;
}

}  // namespace

OccupancyGrid read_moving_ai(std::string_view text, const std::string& file, const OccupancyOptions& options) {
  OccupancyGrid grid = placed_grid(options);
  TextScanner scanner(text, file, {.comment = '\0'});
  expect_word(scanner, "type");
  if (const std::string_view type = scanner.token(); type != "octile")
    scanner.fail("expected the type octile, found " + printable(type));
  const std::int64_t rows = size_line(scanner, "height"), columns = size_line(scanner, "width");
  check_map_size(rows, columns, file + ":" + std::to_string(scanner.line()));
  expect_word(scanner, "map");
  if (static_cast<std::int64_t>(scanner.bytes_left()) < rows * columns)
    scanner.fail("a map of " + std::to_string(rows) + " x " + std::to_string(columns) +
                 " cells, but the file has only " + std::to_string(scanner.bytes_left()) + " bytes left");
  grid.rows = static_cast<int>(rows);
  grid.columns = static_cast<int>(columns);
  grid.source = file;
  grid.blocked.resize(static_cast<std::size_t>(rows * columns));
  for (int row = 0; row < grid.rows; ++row) {
    if (!scanner.next_line())
      scanner.fail("the file ends after " + std::to_string(row) + " of " + std::to_string(rows) + " rows");
    const std::string_view cells = scanner.token();
    if (static_cast<std::int64_t>(cells.size()) != columns)
      scanner.fail("expected a row of " + std::to_string(columns) + " cells, found " + std::to_string(cells.size()));
    scanner.expect_line_end("the row");
    for (int column = 0; column < grid.columns; ++column) {
      const char cell = cells[static_cast<std::size_t>(column)];
      if (kBlocked.find(cell) == std::string_view::npos && kFree.find(cell) == std::string_view::npos)
        scanner.fail("cell " + std::to_string(column) + " is " + printable({&cell, 1}) + ", which is not one of " +
                     std::string(kFree) + " (free) and " + std::string(kBlocked) + " (blocked)");
      grid.blocked[grid.index(row, column)] = kBlocked.find(cell) != std::string_view::npos;
    }
  }
  if (scanner.next_line()) scanner.fail("more rows than the " + std::to_string(rows) + " of the header");
  return grid;
}

void check_map_size(std::int64_t rows, std::int64_t columns, const std::string& place) {
  const auto fits = [](std::int64_t n) { return n >= 1 && n <= OccupancyGrid::kMostCells; };
  if (fits(rows) && fits(columns) && rows * columns <= OccupancyGrid::kMostCells) return;
  throw InputError(place + ": a map of " + std::to_string(rows) + " x " + std::to_string(columns) +
                   " cells; at least one and at most " + std::to_string(OccupancyGrid::kMostCells) + " can be read");
}

}  // namespace leastcost
