// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/merge.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <utility>

#include "app/study/rows/row_json.hpp"
#include "app/study/study_facts.hpp"
#include "app/study/study_files.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

/// What must agree where two journals hold the same repetition of the same cell: everything but times.
std::string without_times(CellResult result) {
  visit_time_columns(result.row, [](const char*, std::optional<double>& seconds) { seconds.reset(); });
  for (TraceRow& line : result.trace) line.seconds = 0;
  return to_json_line(result);
}

/// The results of journals by cell and repetition, and which folder each is from.
class Joined {
 public:
  void add(const fs::path& folder, JournalContent journal) {
    if (first_.empty()) {
      first_ = folder;
      facts_ = journal.facts;
    }
    const std::string reason = difference(facts_, journal.facts);
    if (!reason.empty())
      throw InputError(
          fmt::format("{} and {} are not of the same study: {}", first_.string(), folder.string(), reason));
    for (CellResult& result : journal.results) {
      const std::pair key(result.row.cell, result.row.repetition);
      const auto [known, is_new] = results_.try_emplace(key, folder, result);
      if (!is_new && without_times(known->second.second) != without_times(result))
        throw InputError(fmt::format("{} and {} disagree about cell {}, repetition {}", known->second.first.string(),
                                     folder.string(), key.first, key.second));
    }
  }

  JournalContent take() {
    JournalContent all{facts_, {}, {}};
    for (auto& [key, from] : results_) all.results.push_back(std::move(from.second));
    return all;
  }

 private:
  fs::path first_;
  StudyFacts facts_;
  std::map<std::pair<long, long>, std::pair<fs::path, CellResult>> results_;
};

std::string journal_text(const JournalContent& journal) {
  std::string text = facts_line(journal.facts, journal.shard);
  for (const CellResult& result : journal.results) text += to_json_line(result) + "\n";
  return text;
}

}  // namespace

StudyOutcome merge_studies(const MergeRequest& request) {
  ManifestFacts manifest;
  manifest.kind = "study";
  manifest.arguments = request.arguments;
  manifest.started = std::chrono::system_clock::now();
  Joined joined;
  for (const fs::path& shard : request.folders) {
    const fs::path file = shard / "journal.jsonl";
    joined.add(shard, read_journal(file));
    manifest.inputs.push_back({"journal", fs::absolute(file).lexically_normal(), sha256_of_file(file)});
  }
  const StudyGrid grid = load_grid(request.folders.front() / "study.resolved.yaml", {});
  if (request.loaded) request.loaded();
  OutputFolder folder(request.output, request.force);
  StudyOutcome outcome{joined.take(), folder.target(), false};
  manifest.seed = outcome.journal.facts.seed;
  folder.write("journal.jsonl", journal_text(outcome.journal));
  folder.write("study.resolved.yaml", resolved_study(grid, folder.target()));
  for (const auto& [name, content] : study_files(outcome.journal)) folder.write(name, content);
  manifest.finished = std::chrono::system_clock::now();
  folder.write("manifest.json", manifest_json(manifest));
  folder.commit();
  return outcome;
}

}  // namespace leastcost::app
