// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/pairs/pair_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include <leastcost/catalogue/yaml/diagnostics.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "catalogue/output/csv_text.hpp"

namespace leastcost {
namespace {

constexpr std::size_t kLongestLine = 1 << 20;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// A cell in a message, however long it is.
std::string shown(const std::string& cell) {
  constexpr std::size_t kLongest = 40;
  return in_quotes(cell.size() <= kLongest ? cell : cell.substr(0, kLongest) + "...");
}

/// A number with a plus is one too.
std::string without_plus(const std::string& cell) {
  return cell.size() > 1 && cell[0] == '+' && cell[1] != '-' ? cell.substr(1) : cell;
}

std::string vertex_fault(const std::string& cell, std::optional<int>& vertex) {
  if (cell.empty()) return "is empty; use a whole number from 0";
  const std::optional<long> value = csv_long(without_plus(cell));
  const bool digits = cell.find_first_not_of("0123456789") == std::string::npos;
  if (!value && !digits) return shown(cell) + " is not a vertex number: use whole numbers from 0";
  if (!value || *value > std::numeric_limits<int>::max()) return shown(cell) + " is too large for a vertex";
  if (*value < 0) return shown(cell) + " is negative; vertices are numbered from 0";
  vertex = static_cast<int>(*value);
  return "";
}

std::string coordinate_fault(const std::string& cell, double& value) {
  if (cell.empty()) return "is empty; use a number";
  const std::optional<double> read = csv_double(without_plus(cell));
  if (!read) return shown(cell) + " is not a number, or overflows";
  if (!std::isfinite(*read)) return shown(cell) + " is not finite";
  value = *read;
  return "";
}

std::string columns_of_points(const std::vector<std::string>& coordinates) {
  std::string out;
  for (const char* end : {"source_", "target_"})
    for (const std::string& name : coordinates) out += (out.empty() ? "" : ",") + std::string(end) + name;
  return out;
}

}  // namespace

PairReader::PairReader(const std::filesystem::path& file, const std::vector<std::string>& coordinates,
                       bool has_vertices, bool on_earth)
    : file_(file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(file.string() +
                     (std::filesystem::exists(file, error) ? ": is not a regular file" : ": no such file"));
  size_ = static_cast<double>(std::filesystem::file_size(file, error));
  in_.open(file, std::ios::binary);
  if (!in_) throw InputError(file.string() + ": cannot be opened");
  read_header(coordinates, has_vertices, on_earth);
  first_ = next();
  if (!first_) throw InputError(file.string() + ": has a header but no pairs");
}

std::string PairReader::place() const { return fmt::format("{}:{}: ", file_.string(), line_); }

/// Into text_; of a line that is too long no more than that. False at the end of the file.
bool PairReader::read_line() {
  text_.clear();
  too_long_ = false;
  std::streambuf& bytes = *in_.rdbuf();
  constexpr int kEnd = std::char_traits<char>::eof();
  int c = bytes.sbumpc();
  if (c == kEnd) return false;
  for (; c != kEnd && c != '\n'; c = bytes.sbumpc()) {
    read_ += 1;
    if (text_.size() < kLongestLine)
      text_ += static_cast<char>(c);
    else
      too_long_ = true;
  }
  read_ += 1;
  ++line_;
  return true;
}

/// The cells of the next line that has any, without the blanks around them. False at the end.
bool PairReader::read_row(std::vector<std::string>& cells, std::string& fault) {
  cells.clear();
  fault.clear();
  while (read_line()) {
    if (line_ == 1 && text_.starts_with(kByteOrderMark)) text_.erase(0, kByteOrderMark.size());
    if (trimmed(text_).empty()) continue;
    if (too_long_) {
      fault = "the line has more than a million bytes";
      return true;
    }
    try {
      for (const CsvRecord& record : csv_records(text_, ""))
        for (const std::string& cell : record.fields) cells.push_back(trimmed(cell));
    } catch (const InputError&) {
      cells.clear();
      fault = "a quote is not closed on the same line";
      return true;
    }
    if (!cells.empty()) return true;
  }
  return false;
}

void PairReader::read_header(std::vector<std::string> coordinates, bool has_vertices, bool on_earth) {
  static const std::vector<std::string> kLonlat = {"lon", "lat"};
  std::vector<std::string> names;
  std::string fault;
  const std::string wanted = (has_vertices ? "'source,target' for vertices, or " : "") +
                             in_quotes(columns_of_points(coordinates)) + " for points" +
                             (on_earth ? ", or " + in_quotes(columns_of_points(kLonlat)) : "");
  if (!read_row(names, fault))
    throw InputError(file_.string() + ": is empty; the first line must name the columns: " + wanted);
  if (!fault.empty()) throw InputError(place() + fault);
  columns_ = names.size();
  const auto find = [&](const std::string& name) -> std::optional<Column> {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) return std::nullopt;
    if (std::count(names.begin(), names.end(), name) > 1)
      throw InputError(place() + "two columns have the name " + in_quotes(name));
    return Column{static_cast<std::size_t>(at - names.begin()), name};
  };
  const std::optional<Column> source = find("source"), target = find("target");
  lonlat_ = on_earth && (find("source_lon") || find("target_lon"));
  if (lonlat_) coordinates = kLonlat;
  std::string missing;
  bool any = false;
  for (auto* end : {&source_, &target_})
    for (const std::string& coordinate : coordinates) {
      const std::string name = (end == &source_ ? "source_" : "target_") + coordinate;
      const std::optional<Column> column = find(name);
      any = any || column.has_value();
      if (column)
        end->push_back(*column);
      else if (missing.empty())
        missing = name;
    }
  by_number_ = source.has_value() || target.has_value();
  if (by_number_ && any)
    throw InputError(place() + "the columns give ends both as vertices and as points; expected: " + wanted);
  if (!by_number_ && !any) throw InputError(place() + "the header has no ends; expected: " + wanted);
  if (by_number_ && !has_vertices)
    throw InputError(place() +
                     "the columns 'source' and 'target' are vertices, but this domain has none; expected: " + wanted);
  if (by_number_) {
    if (!source || !target)
      missing = source ? "target" : "source";
    else
      missing.clear();
  }
  if (!missing.empty())
    throw InputError(place() + "the column " + in_quotes(missing) + " is missing; expected: " + wanted);
  if (!by_number_) return;
  source_ = {*source};
  target_ = {*target};
}

/// Why the cells are no end; empty: they are.
std::string PairReader::read_end(const std::vector<std::string>& cells, const std::vector<Column>& columns,
                                 EndOptions& end) const {
  Eigen::VectorXd point(static_cast<Eigen::Index>(columns.size()));
  Eigen::Index i = 0;
  for (const Column& column : columns) {
    const std::string fault =
        by_number_ ? vertex_fault(cells[column.index], end.vertex) : coordinate_fault(cells[column.index], point[i++]);
    if (!fault.empty()) return column.name + ": " + fault;
  }
  if (!by_number_) (lonlat_ ? end.lonlat : end.point) = point;
  return "";
}

std::optional<PairRow> PairReader::next() {
  if (first_) return std::exchange(first_, std::nullopt);
  std::vector<std::string> cells;
  PairRow row;
  if (!read_row(cells, row.fault)) {
    if (in_.bad()) throw InputError(place() + "cannot be read any further");
    return std::nullopt;
  }
  row.number = pairs_++;
  row.line = line_;
  if (!row.fault.empty()) return row;
  if (cells.size() != columns_)
    row.fault = fmt::format("{} cell{}, but the header has {}", cells.size(), cells.size() == 1 ? "" : "s", columns_);
  if (row.fault.empty()) row.fault = read_end(cells, source_, row.source);
  if (row.fault.empty()) row.fault = read_end(cells, target_, row.target);
  return row;
}

void PairReader::skip(long count) {
  for (long i = 0; i < count; ++i)
    if (!next()) throw InputError(fmt::format("{}: has {} pairs, but {} are done", file_.string(), i, count));
}

double PairReader::part() const { return size_ > 0 ? std::min(1.0, read_ / size_) : 1; }

}  // namespace leastcost
