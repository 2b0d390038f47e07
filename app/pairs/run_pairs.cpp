// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/pairs/run_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "app/pairs/pair_log.hpp"
#include "catalogue/output/growing_folder.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/output/output_folder.hpp"
#include "catalogue/output/results.hpp"
#include "catalogue/pairs/rows.hpp"
#include "catalogue/run/run_origin.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kLog = "paths.jsonl";
constexpr const char* kManifest = "manifest.json";
constexpr const char* kConfig = "config.resolved.yaml";

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Throws OutputRefused where the lines in a folder are of another configuration, or of other data. `config`: every
/// option of this one.
void check_same(const fs::path& folder, const std::string& config, const RunOrigin& origin) {
  const auto refuse = [&](const std::string& why) {
    throw OutputRefused(
        fmt::format("{}: belongs to another run: {}; use --force to start again", folder.string(), why));
  };
  if (bytes_of(folder / kConfig) != config) refuse("the options have changed");
  const Json manifest = Json::parse(bytes_of(folder / kManifest), nullptr, false);
  std::vector<std::string> then;
  if (manifest.is_object() && manifest.contains("inputs"))
    for (const Json& input : manifest["inputs"])
      if (input.is_object() && input.value("role", "") == "data") then.push_back(input.value("sha256", ""));
  std::vector<std::string> now;
  for (const InputFile& input : origin.inputs)
    if (input.role == "data") now.push_back(input.sha256);
  if (then != now) refuse("one of its input files has changed");
}

void write_manifest(const fs::path& folder, const RunOrigin& origin, const RunRequest& request) {
  ManifestFacts facts;
  facts.kind = "pairs";
  facts.arguments = request.arguments;
  facts.inputs = origin.inputs;
  facts.seed = origin.config.seed;
  facts.started = origin.started;
  facts.finished = std::chrono::system_clock::now();
  write_whole_file(folder / kManifest, manifest_json(facts));
}

std::string resolved(const RunOrigin& origin, const fs::path& folder) {
  return "# Every option of this run, including defaults. To repeat the run: `leastcost run` on this file.\n" +
         resolved_yaml(origin.config, from_output(origin.folder, folder));
}

Json spectrum_json(const Spectrum& spectrum) {
  if (spectrum.empty()) return nullptr;
  return {{"median", number(spectrum.median())},
          {"worst", number(spectrum.greatest())},
          {"worst_pair", spectrum.greatest_of()}};
}

const char* status_of(const PairsOutcome& outcome) {
  if (outcome.interrupted) return "interrupted";
  if (outcome.summary.failed() > 0) return "failed";
  return outcome.summary.all_certified() ? "certified" : "uncertified";
}

}  // namespace

std::string result_json(const PairsOutcome& outcome, const std::string& name) {
  const PairSummary& summary = outcome.summary;
  const RunSeconds& seconds = outcome.seconds;
  Json outcomes = Json::object(), proofs = Json::object();
  for (const auto& [word, count] : summary.outcomes) outcomes[word] = count;
  for (const auto& [word, count] : summary.proofs) proofs[word] = count;
  Json out;
  out["schema_version"] = kSchemaVersion;
  out["name"] = name;
  out["status"] = status_of(outcome);
  out["certified"] = !outcome.interrupted && summary.all_certified();
  out["pairs"] = summary.count;
  out["outcomes"] = std::move(outcomes);
  out["proofs"] = proofs.empty() ? Json(nullptr) : std::move(proofs);
  out["unit"] = outcome.unit;
  out["notes"] = outcome.notes;
  out["relative_error"] = spectrum_json(summary.errors);
  out["seconds_per_pair"] = spectrum_json(summary.seconds);
  out["seconds"] = {{"read", seconds.read},
                    {"compose", seconds.compose},
                    {"search", seconds.search},
                    {"pairs", summary.count - outcome.found},
                    {"threads", outcome.threads}};
  return to_text(out);
}

PairsLook look_at_pairs(const Run& run) {
  PairReader reader = reader_of_pairs(run);
  PairsLook look;
  look.by_number = reader.by_number();
  while (const std::optional<PairRow> row = reader.next()) {
    ++look.count;
    if (row->fault.empty()) continue;
    ++look.faulty;
    if (look.first_fault.empty()) look.first_fault = fmt::format("line {}: {}", row->line, row->fault);
  }
  return look;
}

PairsOutcome run_pairs(const Run& run, const PairsRequest& request) {
  const RunOrigin& origin = *run.origin;
  PairReader reader = reader_of_pairs(run);
  PairsOutcome outcome;
  outcome.threads = request.threads;
  outcome.seconds = run.seconds;
  outcome.notes = run.parts.notes;
  outcome.unit = run.parts.problem.cost->traits().unit;
  outcome.output =
      prepare_folder({output_of(request.run, run), kLog, "run of many pairs", request.run.force, request.resume});
  const fs::path& folder = outcome.output;
  const std::string config = resolved(origin, folder);
  std::error_code error;
  const bool begun = fs::file_size(folder / kLog, error) > 0 && !error;
  const bool keep = request.resume && begun;
  if (keep) check_same(folder, config, origin);
  if (!keep) write_manifest(folder, origin, request.run);  // from now on the folder is known as ours
  PairLog log(folder / kLog, keep, outcome.summary);
  if (!keep) {
    clear_folder(folder, kLog);
    write_whole_file(folder / kConfig, config);
  }
  outcome.found = outcome.summary.count;
  reader.skip(outcome.found);

  const auto start = std::chrono::steady_clock::now();
  const auto done = [&](const PairResult& result) {
    const std::string line = result.line + "\n";
    outcome.summary.add(facts_of(result));
    const bool written = log.append(line);
    if (request.line) request.line(line, written);
    if (request.observe) request.observe({outcome.summary.count, reader.part()});
  };
  const PairsOptions options{request.threads, origin.config.pair_points, true, request.stop_requested};
  outcome.interrupted = !solve_rows(
      run, [&] { return reader.next(); }, done, options);
  log.finish();
  outcome.seconds.search = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_manifest(folder, origin, request.run);
  write_whole_file(folder / "result.json", result_json(outcome, run.name));
  return outcome;
}

}  // namespace leastcost::app
