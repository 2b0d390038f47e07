// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/app/report/report.hpp>

#include <leastcost/framework/base/errors.hpp>
#include "app/report/page/results_folder.hpp"
#include "app/report/run/run_report.hpp"
#include "app/report/study/study_report.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost {

namespace fs = std::filesystem;

std::vector<ReportFile> make_report(const fs::path& folder) {
  const std::string kind = app::kind_of_results(folder);
  if (kind == "study") return app::study_report(folder);
  if (kind == "pairs")
    throw InputError(folder.string() + ": a run of many pairs has no report; the results are in paths.jsonl");
  return {{"report.html", app::run_report(folder)}};
}

fs::path write_report(const fs::path& folder) {
  for (const ReportFile& file : make_report(folder)) write_whole_file(folder / file.name, file.content);
  return folder / "report.html";
}

}  // namespace leastcost
