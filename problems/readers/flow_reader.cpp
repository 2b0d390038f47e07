// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/flow_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/file_content.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// Columns of a row; between two commas there may be nothing, between blanks there is always something.
std::vector<std::string_view> columns_of(std::string_view row) {
  std::vector<std::string_view> columns;
  row = trimmed(row.substr(0, row.find('#')));
  if (row.empty()) return columns;
  const bool marked = row.find_first_of(",;") != std::string_view::npos;
  const std::string_view separators = marked ? ",;" : kBlanks;
  for (std::size_t begin = 0; begin <= row.size();) {
    const std::size_t end = std::min(row.find_first_of(separators, begin), row.size());
    const std::string_view column = trimmed(row.substr(begin, end - begin));
    if (marked || !column.empty()) columns.push_back(column);
    begin = end + 1;
  }
  return columns;
}

bool parse(std::string_view word, double& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

/// Where the columns of a flow are.
class FlowColumns {
 public:
  explicit FlowColumns(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {
    for (std::size_t k = 0; k < 2 * dimension_; ++k) at_.push_back(k);
  }
  std::size_t count() const { return at_.size(); }
  std::size_t operator[](std::size_t k) const { return at_[k]; }
  bool is_velocity(std::size_t k) const { return k >= dimension_; }
  std::string_view name(std::size_t k) const {
    static constexpr std::array<std::string_view, 6> kNames = {"x", "y", "z", "u", "v", "w"};
    return kNames[k < dimension_ ? k : k - dimension_ + 3];
  }
  /// The first name that the header lacks; empty: all were found.
  std::string_view find(const std::vector<std::string_view>& header) {
    for (std::size_t k = 0; k < at_.size(); ++k) {
      const auto found = std::find(header.begin(), header.end(), name(k));
      if (found == header.end()) return name(k);
      at_[k] = static_cast<std::size_t>(found - header.begin());
    }
    return {};
  }

 private:
  std::size_t dimension_;
  std::vector<std::size_t> at_;
};

/// The numbers of a row, where they count.
void append_row(const std::vector<std::string_view>& words, const FlowColumns& columns, const std::string& place,
                std::vector<double>& values) {
  for (std::size_t k = 0; k < columns.count(); ++k) {
    if (columns[k] >= words.size())
      throw InputError(place + "has " + std::to_string(words.size()) + " columns; '" + std::string(columns.name(k)) +
                       "' is number " + std::to_string(columns[k] + 1));
    const std::string_view word = words[columns[k]];
    double value = std::numeric_limits<double>::quiet_NaN();
    const bool number = word.empty() || parse(word, value);
    if (!number || std::isinf(value) || (std::isnan(value) && !columns.is_velocity(k)))
      throw InputError(place + (word.empty() ? "nothing" : printable(word)) + " stands where the number " +
                       std::string(columns.name(k)) + " should be");
    values.push_back(value);
  }
}

}  // namespace

Eigen::MatrixXd read_flow(const std::filesystem::path& file, int dimension) {
  FlowColumns columns(dimension);
  std::istringstream in(read_content(file));
  std::vector<double> values;
  std::string line;
  bool first = true;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::vector<std::string_view> words = columns_of(line);
    if (words.empty()) continue;
    const std::string place = file.string() + ":" + std::to_string(number) + ": ";
    double value = 0;
    if (std::exchange(first, false) && !parse(words.front(), value)) {
      const std::string_view missing = columns.find(words);
      if (!missing.empty())
        throw InputError(place + "the columns of a flow are " + (dimension == 2 ? "x, y, u, v" : "x, y, z, u, v, w") +
                         "; there is no '" + std::string(missing) + "'");
      continue;
    }
    append_row(words, columns, place, values);
  }
  if (values.empty()) throw InputError(file.string() + ": has no rows");
  const auto width = static_cast<Eigen::Index>(columns.count());
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), width, static_cast<Eigen::Index>(values.size()) / width)
      .transpose();
}

}  // namespace leastcost
