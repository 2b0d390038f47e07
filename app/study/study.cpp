// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/study.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <set>
#include <utility>

#include "app/study/cell/isolation.hpp"
#include "app/study/rows/row_json.hpp"
#include "app/study/study_facts.hpp"
#include "app/study/study_files.hpp"
#include "catalogue/output/growing_folder.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

/// One repetition of one cell that is still to be run.
struct Task {
  const StudyCell* cell = nullptr;
  long repetition = 0;
};

std::vector<Task> tasks_of(const StudyGrid& grid, const Shard& shard, const JournalContent& journal) {
  std::set<std::pair<long, long>> done;
  for (const CellResult& r : journal.results) done.insert({r.row.cell, r.row.repetition});
  std::vector<Task> tasks;
  for (const StudyCell& cell : grid.cells)
    for (long repetition = 0; repetition < grid.config.repetitions; ++repetition)
      if (shard.has(cell.number) && cell.skipped.empty() && done.count({cell.number, repetition}) == 0)
        tasks.push_back({&cell, repetition});
  return tasks;
}

/// What several tasks have in common is made once, in this process, when the first of them begins: their processes
/// inherit it. What only one task needs is left to it, and so to the processes that run beside each other.
class SharedWork {
 public:
  SharedWork(const StudyRequest& request, const std::vector<Task>& tasks) : prepare_(request.prepare) {
    for (const Task& task : tasks) ++left_[key_of(*task.cell)];
  }

  void before(const StudyCell& cell) {
    const auto work = left_.find(key_of(cell));
    if (work == left_.end()) return;  // done
    const bool shared = work->second > 1;
    left_.erase(work);
    if (shared && prepare_) prepare_(cell);
  }

 private:
  /// A hash, as a study may have a million cells. Where two agree by chance, the cells of one do the work themselves.
  std::size_t key_of(const StudyCell& cell) {
    const auto [key, is_new] = keys_.try_emplace(cell.number);
    if (is_new) key->second = std::hash<std::string>()(shared_composition(cell));
    return key->second;
  }

  std::function<void(const StudyCell&)> prepare_;
  std::map<long, std::size_t> keys_;         ///< by number of the cell
  std::map<std::size_t, std::size_t> left_;  ///< tasks by key, until the first of them has begun
};

/// What became of the process of a cell, as a result.
CellResult result_of(const Task& task, IsolatedEnd end) {
  using How = IsolatedEnd::How;
  CellResult result{row_of(*task.cell, task.repetition), {}};
  switch (end.how) {
    case How::done: return from_json_line(end.text);
    case How::timeout: result.row.outcome = outcome::kTimeout; break;
    case How::memory: result.row.outcome = outcome::kMemory; break;
    case How::crash: result.row.outcome = outcome::kCrash; break;
    case How::error: result.row.outcome = outcome::kError; break;
  }
  result.row.message = std::move(end.text);
  return result;
}

StudyGrid grid_of(const StudyRequest& request) {
  const fs::path& file = request.config_file;
  if (!request.text) return load_grid(file, request.overrides, request.externals);
  return checked_grid(
      parse_study(*request.text, file.string(), file.parent_path(), request.overrides, request.externals));
}

std::vector<InputFile> inputs_of(const StudyRequest& request, const StudyGrid& grid, const StudyFacts& facts) {
  std::vector<InputFile> inputs;
  std::vector<fs::path> files = grid.inputs;
  if (request.text) {
    inputs.push_back({"configuration", "<" + files.front().string() + ">", sha256_of_text(*request.text)});
    files.erase(files.begin());
  }
  for (const fs::path& file : files)
    inputs.push_back({"configuration", fs::absolute(file).lexically_normal(), sha256_of_file(file)});
  for (const auto& [file, hash] : facts.data)
    inputs.push_back({"data", fs::absolute(grid.file.parent_path() / file).lexically_normal(), hash});
  return inputs;
}

/// Runs the tasks; false when stopped.
bool run_tasks(const StudyRequest& request, const StudyGrid& grid, const std::vector<Task>& tasks, Journal& journal,
               JournalContent& content) {
  StudyProgress progress{content.results.size(), content.results.size() + tasks.size(), content.results.size(),
                         nullptr};
  if (request.observe) request.observe(progress);
  SharedWork shared(request, tasks);
  const double limit = grid.config.max_seconds ? *grid.config.max_seconds + grid.config.grace_seconds : 0;
  IsolatedJobs jobs;
  jobs.count = tasks.size();
  jobs.parallel = request.parallel;
  jobs.stop_requested = request.stop_requested;
  jobs.job = [&](std::size_t i) {
    shared.before(*tasks[i].cell);
    const auto work = [&, i] {
      journal.forget();
      return to_json_line(request.run(*tasks[i].cell, tasks[i].repetition));
    };
    return IsolatedJob{work, limit, grid.config.max_memory.value_or(0)};
  };
  jobs.ended = [&](std::size_t i, IsolatedEnd end) {
    content.results.push_back(result_of(tasks[i], std::move(end)));
    journal.append(content.results.back());
    ++progress.finished;
    progress.row = &content.results.back().row;
    if (request.observe) request.observe(progress);
  };
  return run_isolated(jobs);
}

Journal open_journal(const StudyRequest& request, const StudyFacts& facts, StudyOutcome& outcome) {
  const fs::path file = outcome.output / "journal.jsonl";
  if (request.resume) return Journal::resume(file, facts, request.shard, outcome.journal);
  Journal journal = Journal::create(file, facts, request.shard, request.force);
  clear_folder(outcome.output, "journal.jsonl");
  outcome.journal = {facts, request.shard, {}};
  return journal;
}

}  // namespace

fs::path output_of(const StudyRequest& request, const StudyGrid& grid) {
  return request.output.empty() ? fs::path("results") / grid.name : request.output;
}

StudyOutcome run_study(const StudyRequest& request) {
  ManifestFacts manifest;
  manifest.kind = "study";
  manifest.arguments = request.arguments;
  manifest.started = std::chrono::system_clock::now();
  const StudyGrid grid = grid_of(request);
  StudyOutcome outcome;
  outcome.output = prepare_folder({output_of(request, grid), "journal.jsonl", "study", request.force, request.resume});
  const StudyFacts facts = facts_of(grid);
  if (request.loaded) request.loaded();
  manifest.seed = facts.seed;
  manifest.inputs = inputs_of(request, grid, facts);
  const auto write_manifest = [&] {
    manifest.finished = std::chrono::system_clock::now();
    write_whole_file(outcome.output / "manifest.json", manifest_json(manifest));
  };
  if (!fs::exists(outcome.output / "manifest.json")) write_manifest();  // from now on the folder is known as ours
  Journal journal = open_journal(request, facts, outcome);
  write_manifest();
  write_whole_file(outcome.output / "study.resolved.yaml", resolved_study(grid, outcome.output));
  const std::vector<Task> tasks = tasks_of(grid, request.shard, outcome.journal);
  outcome.interrupted = !run_tasks(request, grid, tasks, journal, outcome.journal);
  write_manifest();
  write_study_files(outcome.output, outcome.journal);
  return outcome;
}

}  // namespace leastcost::app
