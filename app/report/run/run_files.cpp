// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include <leastcost/framework/errors.hpp>
#include "app/study/rows/csv_text.hpp"

namespace leastcost::app {

namespace fs = std::filesystem;

NumberTable::NumberTable(const fs::path& file) : file_(file.string()) {
  const std::vector<CsvRecord> records = csv_records(text_of_file(file), file_);
  if (records.empty()) throw InputError(file_ + ": is empty");
  names_ = records[0].fields;
  columns_.resize(names_.size());
  for (std::size_t r = 1; r < records.size(); ++r) {
    const CsvRecord& record = records[r];
    if (record.fields.size() != names_.size())
      throw InputError(fmt::format("{}:{}: {} fields under {} names; is the file cut off?", file_, record.line,
                                   record.fields.size(), names_.size()));
    for (std::size_t c = 0; c < names_.size(); ++c) {
      const std::string& field = record.fields[c];
      const std::optional<double> value = field.empty() ? std::numeric_limits<double>::quiet_NaN() : csv_double(field);
      if (!value)
        throw InputError(fmt::format("{}:{}: '{}' under '{}' is not a number", file_, record.line, field, names_[c]));
      columns_[c].push_back(*value);
    }
  }
}

bool NumberTable::has(const std::string& column) const {
  return std::find(names_.begin(), names_.end(), column) != names_.end();
}

const std::vector<double>& NumberTable::operator[](const std::string& column) const {
  const auto found = std::find(names_.begin(), names_.end(), column);
  if (found == names_.end()) throw InputError(file_ + ": has no column '" + column + "'");
  return columns_[static_cast<std::size_t>(found - names_.begin())];
}

namespace {

/// The names of the coordinates of a table of points: they come after the index, whatever the domain calls them.
std::vector<std::string> coordinates_of(const NumberTable& table, int dimension, const std::string& file) {
  const std::vector<std::string>& names = table.names();
  const auto count = static_cast<std::size_t>(std::max(0, dimension));
  if (names.size() <= count)
    throw InputError(
        fmt::format("{}: has {} columns, an index and {} coordinates are wanted", file, names.size(), dimension));
  return {names.begin() + 1, names.begin() + 1 + dimension};
}

}  // namespace

RunFiles read_run_files(const fs::path& folder) {
  RunFiles files{JsonFile(folder / "result.json"),
                 JsonFile(folder / "manifest.json"),
                 text_of_file(folder / "config.resolved.yaml"),
                 NumberTable(folder / "path.csv"),
                 NumberTable(folder / "history.csv"),
                 {},
                 read_scene(text_of_file(folder / "scene.json"), (folder / "scene.json").string()),
                 {},
                 {}};
  if (fs::exists(folder / "residuals.csv")) files.residuals.emplace_back(folder / "residuals.csv");
  const double dimension = files.result.number("problem.dimensions.ambient");
  if (dimension != files.scene.dimension)
    throw InputError((folder / "scene.json").string() +
                     ": belongs to another run than result.json: the dimensions differ");
  files.coordinates = coordinates_of(files.path, files.scene.dimension, (folder / "path.csv").string());
  files.points.resize(files.scene.dimension, static_cast<Index>(files.path.rows()));
  for (std::size_t i = 0; i < files.coordinates.size(); ++i)
    files.points.row(static_cast<Index>(i)) = Eigen::Map<const Eigen::RowVectorXd>(
        files.path[files.coordinates[i]].data(), static_cast<Index>(files.path.rows()));
  return files;
}

}  // namespace leastcost::app
