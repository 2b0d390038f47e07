// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/report/page/json_file.hpp"
#include "catalogue/scene/scene.hpp"

namespace leastcost::app {

/// A CSV file of numbers: columns with names, all equally long. An empty field is NaN.
class NumberTable {
 public:
  /// Throws InputError with the line of what is wrong.
  explicit NumberTable(const std::filesystem::path& file);
  bool has(const std::string& column) const;
  /// Throws InputError where there is no such column.
  const std::vector<double>& operator[](const std::string& column) const;
  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].size(); }

 private:
  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

/// The files of a run that its report is made of.
struct RunFiles {
  JsonFile result, manifest;
  std::string configuration;
  NumberTable path, history;
  std::vector<NumberTable> residuals;  ///< one, or none where the question has no meaning
  Scene scene;
  Points points;                         ///< of path.csv, ambient, d x m
  std::vector<std::string> coordinates;  ///< their names there
  std::optional<JsonFile> clicks;        ///< of clicks.json, which only a report reads
};

/// The ends of its path, d x 2; of a ring none.
Points ends_of(const RunFiles& files);

/// Throws InputError.
RunFiles read_run_files(const std::filesystem::path& folder);

}  // namespace leastcost::app
