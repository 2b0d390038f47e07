// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/output/csv_text.hpp"
#include "problems/formula/coordinate_names.hpp"

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

/// The names of the coordinates of a table of points, which stand between the index and the costs, whatever the domain
/// calls them; after those of space may be those of a chart.
std::vector<std::string> coordinates_of(const NumberTable& table, int dimension) {
  const std::vector<std::string>& all = table.names();
  std::vector<std::string> names;
  for (std::size_t i = 1; i < all.size() && all[i] != "segment_cost" && static_cast<int>(names.size()) < dimension; ++i)
    names.push_back(all[i]);
  if (static_cast<int>(names.size()) < dimension) return coordinate_names(dimension);  // one of them is missing
  return names;
}

}  // namespace

Points ends_of(const RunFiles& files) {
  if (files.result.flag("ring") || files.points.cols() == 0) return Points(files.points.rows(), 0);
  Points ends(files.points.rows(), 2);
  ends << files.points.leftCols(1), files.points.rightCols(1);
  return ends;
}

RunFiles read_run_files(const fs::path& folder) {
  RunFiles files{JsonFile(folder / "result.json"),
                 JsonFile(folder / "manifest.json"),
                 text_of_file(folder / "config.resolved.yaml"),
                 NumberTable(folder / "path.csv"),
                 NumberTable(folder / "history.csv"),
                 {},
                 read_scene(text_of_file(folder / "scene.json"), (folder / "scene.json").string()),
                 {},
                 {},
                 {}};
  if (fs::exists(folder / "residuals.csv")) files.residuals.emplace_back(folder / "residuals.csv");
  const double dimension = files.result.number("problem.dimensions.ambient");
  if (dimension != files.scene.dimension)
    throw InputError((folder / "scene.json").string() +
                     ": belongs to a different run than result.json: the dimensions differ");
  files.coordinates = coordinates_of(files.path, files.scene.dimension);
  files.points.resize(files.scene.dimension, static_cast<Index>(files.path.rows()));
  for (std::size_t i = 0; i < files.coordinates.size(); ++i)
    files.points.row(static_cast<Index>(i)) = Eigen::Map<const Eigen::RowVectorXd>(
        files.path[files.coordinates[i]].data(), static_cast<Index>(files.path.rows()));
  return files;
}

}  // namespace leastcost::app
