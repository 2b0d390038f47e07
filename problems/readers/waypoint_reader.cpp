// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/waypoint_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

std::vector<std::string> split(std::string line) {
  line = line.substr(0, line.find('#'));
  std::vector<std::string> words;
  std::size_t begin = 0;
  constexpr std::string_view separators = ",; \t\r";
  while ((begin = line.find_first_not_of(separators, begin)) != std::string::npos) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

std::optional<double> number(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Columns of the coordinates: those the header names, or the first ones.
std::vector<std::size_t> pick_columns(const std::vector<std::string>& header, const std::vector<std::string>& names) {
  std::vector<std::size_t> named, first;
  for (const std::string& name : names) {
    named.push_back(static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin()));
    first.push_back(first.size());
  }
  const bool all_named = std::all_of(named.begin(), named.end(), [&](std::size_t c) { return c < header.size(); });
  return all_named ? named : first;
}

}  // namespace

Eigen::MatrixXd read_waypoints(const std::filesystem::path& file, const std::vector<std::string>& names) {
  std::ifstream in(file);
  if (!in) throw InputError(file.string() + ": cannot be opened");
  if (names.empty()) throw InputError(file.string() + ": the columns of coordinates have no names");
  std::vector<std::size_t> columns = pick_columns({}, names);
  std::vector<double> values;
  std::string line;
  bool first = true;
  for (int row = 1; std::getline(in, line); ++row) {
    const std::vector<std::string> words = split(line);
    if (words.empty()) continue;
    if (std::exchange(first, false) && !number(words.front())) {
      columns = pick_columns(words, names);
      continue;
    }
    const std::string place = file.string() + ":" + std::to_string(row) + ": ";
    for (const std::size_t column : columns) {
      if (column >= words.size())
        throw InputError(place + std::to_string(words.size()) + " columns, but a point has " +
                         std::to_string(names.size()) + " coordinates");
      const std::optional<double> value = number(words[column]);
      if (!value) throw InputError(place + "'" + words[column] + "' is not a finite number");
      values.push_back(*value);
    }
  }
  if (values.empty()) throw InputError(file.string() + ": has no points");
  const auto rows = static_cast<Eigen::Index>(names.size());
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), rows, static_cast<Eigen::Index>(values.size()) / rows);
}

}  // namespace leastcost
