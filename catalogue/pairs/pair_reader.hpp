// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost {

/// One row of a file of pairs: two ends, or why it is none.
struct PairRow {
  long number = 0;  ///< of the pair, from 0 in the order of the file
  long line = 0;    ///< of the file, from 1
  EndOptions source, target;
  std::string fault;  ///< empty: both ends could be read
};

/// Reads a file of pairs row by row, so that it may be of any length. CSV, one pair per line; its header says what the
/// columns are, in any order: `source,target` are numbers of vertices, `source_x,source_y,target_x,target_y` the
/// coordinates of points by their names in the domain, `source_lon,source_lat,target_lon,target_lat` places on the
/// Earth. Other columns are left alone. Cells may stand in quotes, lines may end in \r\n, empty lines are no pairs.
class PairReader {
 public:
  /// `coordinates`: the names of the coordinates of points; `has_vertices`: of the domain; `on_earth`: longitudes and
  /// latitudes mean something there. Throws InputError where the
  /// file cannot be read, its header names no ends or none that the domain can have, or no pair follows.
  PairReader(const std::filesystem::path& file, const std::vector<std::string>& coordinates, bool has_vertices,
             bool on_earth = false);

  /// The next pair; nothing at the end. Throws InputError where the file cannot be read on.
  std::optional<PairRow> next();
  /// Passes over so many pairs.
  void skip(long count);
  /// How much of the file has been read, from 0 to 1.
  double part() const;
  bool by_number() const { return by_number_; }

 private:
  struct Column {
    std::size_t index = 0;  // in a row
    std::string name;
  };
  bool read_line();
  bool read_row(std::vector<std::string>& cells, std::string& fault);
  void read_header(std::vector<std::string> coordinates, bool has_vertices, bool on_earth);
  std::string read_end(const std::vector<std::string>& cells, const std::vector<Column>& columns,
                       EndOptions& end) const;
  std::string place() const;

  std::filesystem::path file_;
  std::ifstream in_;
  double size_ = 0;            // of the file, bytes
  double read_ = 0;            // of these
  std::string text_;           // the line that was read last
  bool too_long_ = false;      // so much that its end was passed over
  long line_ = 0, pairs_ = 0;  // read so far
  bool by_number_ = false;     // of vertices
  bool lonlat_ = false;        // points are longitudes and latitudes
  std::size_t columns_ = 0;    // of the header
  std::vector<Column> source_, target_;
  std::optional<PairRow> first_;  // read to know that there is one
};

}  // namespace leastcost
