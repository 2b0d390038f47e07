// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/study_files.hpp"

#include <algorithm>
#include <tuple>

#include "app/study/rows/run_table.hpp"
#include "app/study/study_summary.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost::app {

void sort_results(JournalContent& journal) {
  std::sort(journal.results.begin(), journal.results.end(), [](const CellResult& a, const CellResult& b) {
    return std::tie(a.row.cell, a.row.repetition) < std::tie(b.row.cell, b.row.repetition);
  });
}

std::map<std::string, std::string> study_files(const JournalContent& journal) {
  RunTable table{journal.facts.swept_keys, {}};
  std::vector<TraceRow> traces;
  for (const CellResult& r : journal.results) {
    table.rows.push_back(r.row);
    traces.insert(traces.end(), r.trace.begin(), r.trace.end());
  }
  return {{"runs.csv", runs_csv(table)}, {"traces.csv", traces_csv(traces)}, {"summary.json", summary_json(journal)}};
}

void write_study_files(const std::filesystem::path& folder, JournalContent& journal) {
  sort_results(journal);
  for (const auto& [name, content] : study_files(journal)) write_whole_file(folder / name, content);
}

}  // namespace leastcost::app
