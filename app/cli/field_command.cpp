// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/field/field_files.hpp"
#include "catalogue/output/csv_text.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/unit_of_cost.hpp"
#include "catalogue/run/run_origin.hpp"

namespace leastcost::app {
namespace {

/// "x,y" as a point.
Eigen::VectorXd point_of(const std::string& text, const std::string& where) {
  const std::size_t comma = text.find(',');
  const auto number = [&](const std::string& word) {
    const std::optional<double> value = csv_double(word);
    if (comma == std::string::npos || !value || !std::isfinite(*value))
      throw InputError(
          fmt::format("{}: expected two numbers with a comma between them, like 3.5,-2, found '{}'", where, text));
    return *value;
  };
  return Eigen::Vector2d(number(text.substr(0, comma)),
                         number(comma == std::string::npos ? "" : text.substr(comma + 1)));
}

/// Points as --from has them: each in words, or many in a file, one a line.
std::vector<Eigen::VectorXd> points_of(const std::vector<std::string>& words, const char* option) {
  std::vector<Eigen::VectorXd> points;
  for (const std::string& word : words) {
    std::ifstream in(word);
    if (!in) {
      if (word.find(',') == std::string::npos)
        throw InputError(fmt::format("{} {}: there is no such file, and it is not a place like 3.5,-2", option, word));
      points.push_back(point_of(word, option));
      continue;
    }
    const std::size_t before = points.size();
    int number = 0;
    for (std::string line; std::getline(in, line);) {
      ++number;
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
      if (!line.empty() && line.front() != '#') points.push_back(point_of(line, fmt::format("{}:{}", word, number)));
    }
    if (points.size() == before) throw InputError(fmt::format("{} {}: the file has no points", option, word));
  }
  return points;
}

/// The problem of a configuration, with the places that the field is from.
struct FieldTask {
  Problem problem;
  std::vector<Eigen::VectorXd> from, to;  ///< coordinates
};

FieldTask field_task(const Run& run, const FieldArguments& arguments) {
  const RunConfig& config = run.origin->config;
  if (config.has_pairs())
    throw InputError("field: the configuration has many pairs of ends: give it one source and one target");
  FieldTask task{run.parts.problem, {}, {}};
  if (config.ring || !config.target || !run.origin->pairs)
    throw InputError("field: needs a configuration with a source and a target");
  for (const Eigen::VectorXd& point : points_of(arguments.from, "--from")) {
    EndOptions source;
    source.point = point;
    try {
      const RunParts parts = run.origin->pairs->compose(source, *config.target, run.origin->pairs->parts());
      task.from.push_back(parts.problem.source.u);
      if (task.from.size() == 1) task.problem = parts.problem;
    } catch (const OptionError& e) {
      throw InputError(fmt::format("--from {},{}: {}", point[0], point[1], e.what()));
    }
  }
  if (task.from.size() > 1 && config.cost.plugin->follows_source)
    throw InputError("field: this cost depends on where the path begins: give one --from at a time");
  if (task.from.empty()) task.from = {run.parts.problem.source.u};
  task.to = {task.problem.target.u};
  return task;
}

/// Whether the file could be written; says so where it could not.
bool write_bytes(const std::string& file, const std::string& text, const Streams& streams) {
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) streams.err << fmt::format("error: cannot write {}\n", file);
  return static_cast<bool>(out);
}

struct Extent {
  std::size_t reached = 0;
  double largest = 0;
};

Extent extent_of(const CostField& field) {
  Extent extent;
  for (const double value : field.values) {
    if (!std::isfinite(value)) continue;
    ++extent.reached;
    extent.largest = std::max(extent.largest, value);
  }
  return extent;
}

nlohmann::ordered_json places_json(const std::vector<Eigen::VectorXd>& places) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Eigen::VectorXd& place : places) all.push_back(numbers(place));
  return all;
}

std::string field_summary_json(const CostField& field, const FieldTask& task, const FieldArguments& arguments,
                               const std::vector<FieldWay>& ways) {
  const Extent extent = extent_of(field);
  nlohmann::ordered_json out = {
      {"schema_version", kSchemaVersion},  {"what", arguments.corridor ? "corridor" : "field"},
      {"output", arguments.output},        {"method", field.method},
      {"directed", field.directed},        {"asymmetry", number(field.asymmetry)},
      {"unit", unit_of_cost(task.problem)}};
  if (arguments.corridor || !arguments.to_here) out["from"] = places_json(task.from);
  if (arguments.corridor) out["to"] = places_json(task.to);
  if (!arguments.corridor && arguments.to_here) out["to"] = places_json(task.from);
  out["columns"] = field.count[0];
  out["rows"] = field.count[1];
  out["lower"] = numbers(field.lower);
  out["step"] = numbers(field.step);
  out["reached"] = extent.reached;
  out["largest"] = number(extent.largest);
  out["error"] = {{"largest", number(field.error)},
                  {"mean", number(field.mean_error)},
                  {"unresolved", field.unresolved},
                  {"kind", "estimate"},
                  {"by", "difference from the field on half as many cells"}};
  out["ways"] = nlohmann::ordered_json::array();
  for (const FieldWay& way : ways)
    out["ways"].push_back({{"begin", numbers(way.points.front())},
                           {"end", numbers(way.points.back())},
                           {"cost", number(way.cost)},
                           {"points", way.points.size()}});
  return to_text(out);
}

std::string field_summary_text(const CostField& field, const FieldTask& task, const FieldArguments& arguments,
                               const std::vector<FieldWay>& ways) {
  const Extent extent = extent_of(field);
  const std::string unit = unit_of_cost(task.problem);
  std::string out = fmt::format("{}: {} x {} nodes, {} reached, the largest value {:.6g} {}\n", arguments.output,
                                field.count[0], field.count[1], extent.reached, extent.largest, unit);
  if (std::isfinite(field.error))
    out += fmt::format(
        "error  about {:.2g} at worst, {:.2g} on average (an estimate, from the field on half as many cells)\n",
        field.error, field.mean_error);
  else
    out += "error  not estimated: half as many cells are too few\n";
  if (field.unresolved > 0)
    out += fmt::format("note: {} nodes are reached only by passages of one or two cells; use a smaller --resolution\n",
                       field.unresolved);
  if (field.directed && !arguments.corridor)
    out += fmt::format("note: there and back differ under this cost; these are costs {} the {}\n",
                       arguments.to_here ? "to" : "from", task.from.size() > 1 ? "places" : "place");
  if (field.asymmetry > CostField::kFaithfulAsymmetry)
    out += fmt::format(
        "note: {}; under such a cost values can be wrong by more than the estimate (leastcost run gives certified "
        "costs "
        "between two places)\n",
        std::isfinite(field.asymmetry)
            ? fmt::format("a move costs up to {:.3g} times the same move back", field.asymmetry)
            : "some moves have no move back");
  for (const FieldWay& way : ways)
    out += fmt::format("way    from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}): {:.10g} {}\n", way.points.front().x(),
                       way.points.front().y(), way.points.back().x(), way.points.back().y(), way.cost, unit);
  return out;
}

}  // namespace

Exit field_command(const FieldArguments& arguments, const Streams& streams) {
  if (arguments.corridor && arguments.to_here)
    throw InputError("--corridor has both directions already: leave out --to-here");
  const FieldFormat format = field_format(arguments.output);  // before any work
  if (!arguments.ways.empty() && arguments.to.empty()) throw InputError("--way needs --to X,Y");
  if (arguments.ways == arguments.output) throw InputError("--way and --output name the same file");
  const Run run = load({arguments.config, arguments.overrides, {}, false, {}});
  const FieldTask task = field_task(run, arguments);
  catch_interrupts();
  Monitor monitor;
  monitor.stop_requested = interrupted;
  CostFieldOptions options{.resolution = arguments.resolution, .to_places = arguments.to_here};
  try {
    CostField field = costs_from(task.problem, task.from, options, monitor);
    std::vector<FieldWay> ways;
    for (const Eigen::VectorXd& place : points_of(arguments.to, "--to")) {
      std::vector<Eigen::Vector2d> points = way_down(field, task.problem, place);
      const double cost = cost_of_way(task.problem, points);
      ways.push_back({std::move(points), cost});
    }
    if (arguments.corridor) {
      options.to_places = true;
      field = corridor(field, costs_from(task.problem, task.to, options, monitor));
    }
    const std::array<std::string, 2> names = {"x", "y"};
    if (!write_bytes(arguments.output, field_text(field, format, names), streams)) return Exit::output;
    if (!arguments.ways.empty() && !write_bytes(arguments.ways, ways_csv(ways, names), streams)) return Exit::output;
    streams.out << (arguments.json ? field_summary_json(field, task, arguments, ways)
                                   : field_summary_text(field, task, arguments, ways));
    return Exit::certified;
  } catch (const Interrupted& e) {
    streams.err << e.what() << "; nothing was written\n";
    return Exit::interrupted;
  }
}

}  // namespace leastcost::app
