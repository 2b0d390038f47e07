// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/rows/row_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/output/csv_text.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(double value) { return std::isfinite(value) ? Json(value) : Json(csv_number(value)); }

double number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (const std::optional<double> special = csv_double(json.get<std::string>())) return *special;
  throw InputError("expected a number");
}

struct Writer {
  Json& out;
  void operator()(const char* name, long value) { out[name] = value; }
  void operator()(const char* name, double value) { out[name] = to_json(value); }
  void operator()(const char* name, const std::string& value) {
    if (!value.empty()) out[name] = value;
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value) {
    if (value) (*this)(name, *value);
  }
};

struct Reader {
  const Json& in;
  void operator()(const char* name, long& value) { value = in.at(name).get<long>(); }
  void operator()(const char* name, double& value) { value = number_of(in.at(name)); }
  void operator()(const char* name, std::string& value) { value = in.value(name, std::string()); }
  template <class T>
  void operator()(const char* name, std::optional<T>& value) {
    if (in.contains(name)) (*this)(name, value.emplace());
  }
};

}  // namespace

std::string to_json_line(const CellResult& result) {
  Json row = Json::object(), trace = Json::array();
  Writer write{row};
  visit_axis_columns(result.row, write);
  row["swept"] = result.row.swept;
  visit_result_columns(result.row, write);
  for (const TraceRow& t : result.trace)
    trace.push_back(
        {t.iteration, t.evaluations, to_json(t.seconds), to_json(t.energy), to_json(t.cost_error), to_json(t.step)});
  return Json{{"row", row}, {"trace", trace}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

CellResult from_json_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    CellResult result;
    Reader read{json.at("row")};
    visit_axis_columns(result.row, read);
    result.row.swept = json.at("row").at("swept").get<std::vector<std::string>>();
    visit_result_columns(result.row, read);
    for (const Json& t : json.at("trace"))
      result.trace.push_back({result.row.cell, result.row.repetition, t.at(0).get<long>(), t.at(1).get<long>(),
                              number_of(t.at(2)), number_of(t.at(3)), number_of(t.at(4)), number_of(t.at(5))});
    return result;
  } catch (const Json::exception& e) {
    throw InputError(e.what());
  }
}

}  // namespace leastcost::app
