// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/rows/run_table.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/output/csv_text.hpp"

namespace leastcost::app {
namespace {

template <class Row, class Visit>
void visit_trace_columns(Row& row, Visit&& visit) {
  visit("cell", row.cell);
  visit("repetition", row.repetition);
  visit("iteration", row.iteration);
  visit("evaluations", row.evaluations);
  visit("seconds", row.seconds);
  visit("energy", row.energy);
  visit("cost_error", row.cost_error);
  visit("step", row.step);
}

std::string text_of(long value) { return std::to_string(value); }
std::string text_of(double value) { return csv_number(value); }
std::string text_of(const std::string& value) { return csv_text_field(value); }
template <class T>
std::string text_of(const std::optional<T>& value) {
  return value ? text_of(*value) : "";
}

/// Collects names, or values, of columns as one line.
struct LineOfNames {
  std::string line;
  template <class T>
  void operator()(const char* name, const T&) {
    add(csv_field(name));
  }
  void add(const std::string& field) { line += (line.empty() ? "" : ",") + field; }
};

struct LineOfValues {
  std::string line;
  bool first = true;
  template <class T>
  void operator()(const char*, const T& value) {
    add(text_of(value));
  }
  void add(const std::string& field) {
    line += (first ? "" : ",") + field;
    first = false;
  }
};

/// The fields of a CSV file by the names in its first line.
class NamedFields {
 public:
  NamedFields(const std::string& text, const std::string& name) : name_(name), records_(csv_records(text, name)) {
    if (records_.empty()) throw InputError(name_ + ": is empty; its first line names the columns");
    const std::vector<std::string>& header = records_[0].fields;
    for (std::size_t i = 0; i < header.size(); ++i) column_[header[i]] = i;
    for (const CsvRecord& record : records_)
      if (record.fields.size() != header.size())
        throw InputError(name_ + ":" + std::to_string(record.line) + ": has " + std::to_string(record.fields.size()) +
                         " fields, the first line names " + std::to_string(header.size()) + " columns");
  }

  const std::vector<std::string>& header() const { return records_[0].fields; }
  std::size_t size() const { return records_.size() - 1; }
  void go_to(std::size_t row) { record_ = &records_[row + 1]; }
  const std::string& field(const char* column) const {
    const auto it = column_.find(column);
    if (it == column_.end()) throw InputError(name_ + ": has no column '" + column + "'");
    return record_->fields[it->second];
  }

  /// Reads one member; the visitor of the column lists.
  template <class T>
  void operator()(const char* column, T& value) const {
    read(column, value);
  }

 private:
  void read(const char* column, std::string& value) const { value = csv_text(field(column)); }
  void read(const char* column, long& value) const { value = parsed(column, csv_long(field(column))); }
  void read(const char* column, double& value) const { value = parsed(column, csv_double(field(column))); }
  template <class T>
  void read(const char* column, std::optional<T>& value) const {
    value.reset();
    if (!field(column).empty()) read(column, value.emplace());
  }
  template <class T>
  T parsed(const char* column, std::optional<T> value) const {
    if (value) return *value;
    throw InputError(name_ + ":" + std::to_string(record_->line) + ": column '" + column +
                     "' must hold a number (found '" + field(column) + "')");
  }

  std::string name_;
  std::vector<CsvRecord> records_;
  std::map<std::string, std::size_t> column_;
  const CsvRecord* record_ = nullptr;
};

/// The columns of a header between `seed` and `outcome`.
std::vector<std::string> swept_keys_of(const std::vector<std::string>& header) {
  const auto seed = std::find(header.begin(), header.end(), "seed");
  const auto outcome = std::find(header.begin(), header.end(), "outcome");
  if (seed == header.end() || outcome <= seed) return {};
  return {seed + 1, outcome};
}

}  // namespace

std::string runs_csv(const RunTable& table) {
  const RunRow blank;
  LineOfNames names;
  visit_axis_columns(blank, names);
  for (const std::string& key : table.swept_keys) names.add(csv_field(key));
  visit_result_columns(blank, names);
  std::string out = names.line + "\n";
  for (const RunRow& row : table.rows) {
    LineOfValues values;
    visit_axis_columns(row, values);
    for (const std::string& value : row.swept) values.add(csv_text_field(value));
    visit_result_columns(row, values);
    out += values.line + "\n";
  }
  return out;
}

std::string traces_csv(const std::vector<TraceRow>& rows) {
  LineOfNames names;
  const TraceRow blank;
  visit_trace_columns(blank, names);
  std::string out = names.line + "\n";
  for (const TraceRow& row : rows) {
    LineOfValues values;
    visit_trace_columns(row, values);
    out += values.line + "\n";
  }
  return out;
}

RunTable read_runs_csv(const std::string& text, const std::string& name) {
  NamedFields fields(text, name);
  RunTable table{swept_keys_of(fields.header()), {}};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    fields.go_to(i);
    RunRow& row = table.rows.emplace_back();
    visit_axis_columns(row, fields);
    for (const std::string& key : table.swept_keys) row.swept.push_back(csv_text(fields.field(key.c_str())));
    visit_result_columns(row, fields);
  }
  return table;
}

std::vector<TraceRow> read_traces_csv(const std::string& text, const std::string& name) {
  NamedFields fields(text, name);
  std::vector<TraceRow> rows(fields.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    fields.go_to(i);
    visit_trace_columns(rows[i], fields);
  }
  return rows;
}

}  // namespace leastcost::app
