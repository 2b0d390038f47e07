// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/report.hpp"

#include "app/report/page/json_file.hpp"
#include "app/report/run/run_report.hpp"
#include "app/report/study/study_report.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost::app {

namespace fs = std::filesystem;

std::vector<ReportFile> make_report(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw InputError(folder.string() + ": is not a folder");
  const fs::path file = folder / "manifest.json";
  if (!fs::exists(file))
    throw InputError(folder.string() +
                     ": has no manifest.json; give the output folder of `leastcost run` or `leastcost study`");
  const JsonFile manifest(file);
  if (!manifest.has("program") || manifest.text("program") != kProgramName)
    throw InputError(file.string() + ": was not written by leastcost");
  if (manifest.has("kind") && manifest.text("kind") == "study") return study_report(folder);
  if (manifest.has("kind") && manifest.text("kind") == "pairs")
    throw InputError(folder.string() + ": a run of many pairs has no report; the results are in paths.jsonl");
  return {{"report.html", run_report(folder)}};
}

fs::path write_report(const fs::path& folder) {
  for (const ReportFile& file : make_report(folder)) write_whole_file(folder / file.name, file.content);
  return folder / "report.html";
}

}  // namespace leastcost::app
