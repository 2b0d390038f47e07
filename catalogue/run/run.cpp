// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/run/run.hpp>
#include <leastcost/framework/family/find_family.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/run/compose.hpp"
#include "catalogue/run/look_elsewhere.hpp"
#include "catalogue/run/pair_composer.hpp"
#include "catalogue/run/preparation.hpp"
#include "catalogue/run/run_checks.hpp"
#include "catalogue/run/run_origin.hpp"
#include "catalogue/run/search.hpp"
#include "framework/base/point_text.hpp"
#include "problems/raster/raster_cells.hpp"

namespace leastcost {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// When a run began, on both clocks.
struct Start {
  Clock::time_point clock = Clock::now();
  std::chrono::system_clock::time_point time = std::chrono::system_clock::now();
};

/// The data as it is when it is used: a file may change while a long run goes on.
std::vector<InputFile> inputs_of(const LoadedConfig& loaded) {
  const auto absolute = [](const std::filesystem::path& p) { return std::filesystem::absolute(p).lexically_normal(); };
  const std::filesystem::path file =
      loaded.file.empty() ? std::filesystem::path("<" + loaded.errors.file() + ">") : absolute(loaded.file);
  std::vector<InputFile> inputs = {{"configuration", file, sha256_of_text(loaded.text)}};
  for (const std::string& name : files_of(loaded.config))
    inputs.push_back({"data", absolute(loaded.folder / name), sha256_of_file(loaded.folder / name)});
  return inputs;
}

/// The place of a text in a configuration; null where it has none of its own.
const ConfigNode* find_text(const ConfigNode& node, const std::string& text) {
  if (node.is_scalar() && node.text == text) return &node;
  const ConfigNode* found = nullptr;
  for (auto item = node.items.begin(); found == nullptr && item != node.items.end(); ++item)
    found = find_text(*item, text);
  for (auto entry = node.entries.begin(); found == nullptr && entry != node.entries.end(); ++entry)
    found = find_text(entry->value, text);
  return found;
}

/// Throws InputError for a file that is not there, with the place where the configuration names it.
void check_files(const LoadedConfig& loaded) {
  for (const std::string& name : files_of(loaded.config)) {
    const std::filesystem::path file = loaded.folder / name;
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() != std::filesystem::file_type::not_found) continue;
    const ConfigNode* named = find_text(loaded.tree, name);
    throw InputError(loaded.errors.where(named == nullptr ? Place{} : named->place) + ": " + file.string() +
                     ": no such file");
  }
}

Run run_of(RunConfig config, std::filesystem::path folder, std::vector<InputFile> inputs, RunParts parts,
           std::shared_ptr<const PairComposer> pairs, const Start& start) {
  Run run;
  run.name = config.name;
  run.max_seconds = config.max_seconds;
  run.parts = parts;
  run.origin = std::make_shared<const RunOrigin>(RunOrigin{std::move(config), std::move(folder), std::move(inputs),
                                                           start.time, std::move(parts), std::move(pairs)});
  return run;
}

Run composed(LoadedConfig loaded, const BuildProgress& progress, const Start& start) {
  const auto stop_at_errors = [&] {
    if (!loaded.errors.empty()) throw ConfigError(loaded.errors);
  };
  stop_at_errors();
  Composer composer(loaded.config, loaded.folder, [&](const OptionError& e) { loaded.add_error(e.key(), e.what()); });
  composer.make_from_options();
  stop_at_errors();
  check_files(loaded);
  composer.make_from_files(progress);
  stop_at_errors();
  const Clock::time_point hashing = Clock::now();
  std::vector<InputFile> inputs = inputs_of(loaded);
  const double hashed = seconds_since(hashing);
  RunParts parts = composer.take();
  if (std::string word = word_on_interpolation(loaded); !word.empty()) parts.notes.push_back(std::move(word));
  std::shared_ptr<const PairComposer> pairs = composer.pairs(parts);
  Run run =
      run_of(std::move(loaded.config), loaded.folder, std::move(inputs), std::move(parts), std::move(pairs), start);
  run.seconds.read = composer.read_seconds() + hashed;
  run.seconds.compose = seconds_since(start.clock) - run.seconds.read;
  return run;
}

/// The monitor of the caller with the time budget of the configuration, which starts now.
Monitor with_budget(const Monitor& monitor, std::optional<double> max_seconds) {
  Monitor limited = monitor;
  if (max_seconds)
    limited.deadline = Monitor::Clock::now() + std::chrono::duration_cast<Monitor::Clock::duration>(
                                                   std::chrono::duration<double>(*max_seconds));
  return limited;
}

/// The path of the configuration, or the best of its family.
void find(RunOutcome& outcome, const Monitor& monitor) {
  RunParts& parts = outcome.parts;
  if (!parts.wants_family()) {
    outcome.result = find_path(parts.problem, *parts.initializer, *parts.solver, parts.options, monitor);
    return;
  }
  Family family = find_family(family_starts(parts), *parts.solver, parts.options, monitor);
  parts.notes.insert(parts.notes.end(), family.notes.begin(), family.notes.end());
  outcome.family = std::move(family.members);
  outcome.result = outcome.family.front().result;
  parts.problem = outcome.family.front().problem;  // its target may be another image of the same point
}

constexpr double kReadOtherwise = 0.02;  // of the cost: the cells and the map between them say different things

/// Says so where the cells of a raster, each constant, make the path cost something else.
void compare_with_cells(RunOutcome& outcome) {
  const auto* map = find_ability<HasRasterCells>(*outcome.parts.problem.cost);
  if (map == nullptr || outcome.result.curve.x.cols() < 2) return;
  const double cost = outcome.result.curve.cost, cells = map->cost_over_cells(outcome.result.curve.x);
  if (!std::isfinite(cost) || std::abs(cells - cost) <= kReadOtherwise * cost) return;
  outcome.parts.notes.push_back(
      fmt::format("this path costs {:.4g} where every cell of the raster is constant, and {:.4g} as the map is "
                  "interpolated ('interpolation: bilinear' goes through the values, 'smooth' evens them out)",
                  cells, cost));
}

/// An end that the caller has replaced is where he put it.
void follow(PlacedEnd& placed, const PathEnd& end) {
  if (placed.end.u.size() != end.u.size() || placed.end.u != end.u) placed = {end.u, end, 0};
}

/// The path is solved: what its waypoints lack takes nothing away from it.
void place_waypoints(RunOutcome& outcome) {
  RunParts& parts = outcome.parts;
  if (!parts.waypoints.wanted()) return;
  try {
    outcome.waypoints = place_waypoints(parts.problem, outcome.result, parts.waypoints);
  } catch (const Error& error) {
    parts.notes.push_back(std::string("there are no waypoints: ") + error.what());
    return;
  }
  const std::optional<Clearance>& clearance = outcome.waypoints->clearance;
  if (!outcome.waypoints->touches) return;
  const bool inside = clearance->upper < 0;
  parts.notes.push_back("the straight moves between the waypoints touch: that from number " +
                        std::to_string(clearance->segment) + " comes " +
                        short_number(std::abs(inside ? clearance->upper : clearance->lower)) +
                        (inside ? "" : " (not decided: perhaps)") + " too near to " + clearance->obstacle +
                        "; more waypoints cut fewer corners");
}

bool same_end(const PathEnd& a, const PathEnd& b) { return a.u.size() == b.u.size() && a.u == b.u; }

bool same_family(const RunParts& a, const RunParts& b) {
  if (a.windings != b.windings || a.family.size() != b.family.size()) return false;
  for (std::size_t i = 0; i < a.family.size(); ++i)
    if (a.family[i].initializer != b.family[i].initializer) return false;
  return true;
}

/// The parts that were replaced after reading, in words.
std::vector<std::string> replaced_parts(const RunParts& parts, const RunParts& as_read) {
  const Problem &now = parts.problem, &then = as_read.problem;
  std::vector<std::string> replaced;
  const auto differs = [&](bool same, const char* what) {
    if (!same) replaced.emplace_back(what);
  };
  differs(now.manifold == then.manifold, "manifold");
  differs(now.cost == then.cost, "cost");
  differs(now.kernel == then.kernel, "kernel");
  differs(same_end(now.source, then.source) && same_end(now.target, then.target), "ends");
  differs(parts.options.points == as_read.options.points && now.ring == then.ring && now.based == then.based, "path");
  differs(parts.initializer == as_read.initializer, "initializer");
  differs(same_family(parts, as_read), "family");
  differs(parts.solver == as_read.solver, "solver");
  differs(parts.options.post_processors == as_read.options.post_processors, "post_process");
  return replaced;
}

}  // namespace

Run load_run(const std::filesystem::path& file, const std::vector<Override>& overrides, const BuildProgress& progress) {
  const Start start;
  return composed(load_config(file, overrides), progress, start);
}

Run parse_run(std::string text, const std::string& name, const std::filesystem::path& folder,
              const std::vector<Override>& overrides, const BuildProgress& progress) {
  const Start start;
  return composed(parse_config(std::move(text), name, folder, overrides), progress, start);
}

Run compose_run(const RunConfig& config, const std::filesystem::path& folder) {
  const Start start;
  Composer composer(config, folder, [](const OptionError& e) { throw OptionError(e); });
  composer.make_from_options();
  composer.make_from_files();
  RunParts parts = composer.take();
  std::shared_ptr<const PairComposer> pairs = composer.pairs(parts);
  Run run = run_of(config, folder, {}, std::move(parts), std::move(pairs), start);
  run.seconds.read = composer.read_seconds();
  run.seconds.compose = seconds_since(start.clock) - run.seconds.read;
  return run;
}

void search(RunOutcome& outcome, std::optional<double> max_seconds, const Monitor& monitor) {
  find(outcome, with_budget(monitor, max_seconds));
  const RunParts& parts = outcome.parts;
  const Result& result = outcome.result;
  if (result.path.u.size() == 0) throw StoppedEarly(result.notes.empty() ? "no path yet" : result.notes.back());
  complete_interrupted(parts.problem, parts.options, outcome.result);
  for (FamilyMember& member : outcome.family) complete_interrupted(member.problem, parts.options, member.result);
}

RunOutcome solve(Run run, const Monitor& monitor) {
  if (!run.origin) throw InputError("a run is made by load_run() or parse_run()");
  if (run.origin->pairs)
    throw InputError(
        "the configuration has many pairs of ends (ends.pairs), and solve() finds one path: give it a "
        "'source' and a 'target'");
  if (!run.parts.solver || !run.parts.initializer) throw InputError("the run has no solver, or no initializer");
  const Clock::time_point start = Clock::now();
  RunOutcome outcome;
  outcome.name = std::move(run.name);
  outcome.parts = std::move(run.parts);
  outcome.seconds = run.seconds;
  outcome.origin = std::move(run.origin);
  RunParts& parts = outcome.parts;
  if (!parts.problem.ring || parts.problem.based) follow(parts.source, parts.problem.source);
  if (!parts.problem.ring) follow(parts.target, parts.problem.target);
  outcome.replaced = replaced_parts(parts, outcome.origin->parts);
  for (const std::string& part : outcome.replaced)
    parts.notes.push_back(part + ": replaced after the configuration was read");
  double prepared = 0;
  if ((run.max_seconds || monitor.deadline) && asks_for_preparation(parts, monitor.deadline.has_value())) {
    const Clock::time_point begin = Clock::now();
    prepare(parts.problem);
    prepared = seconds_since(begin);
  }
  search(outcome, run.max_seconds, monitor);
  if (!run.max_seconds && !monitor.deadline && sees_one_way(outcome.origin->config))
    if (std::string note = look_elsewhere(parts, outcome.result, monitor); !note.empty())
      parts.notes.push_back(std::move(note));
  outcome.result.seconds.prepare += prepared;
  outcome.seconds.search = seconds_since(start);
  place_waypoints(outcome);
  compare_with_cells(outcome);
  outcome.finished = std::chrono::system_clock::now();
  return outcome;
}

}  // namespace leastcost
