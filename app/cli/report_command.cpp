// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <filesystem>
#include <ostream>

#include <leastcost/app/report/report.hpp>
#include "app/cli/command_options.hpp"
#include "app/study/rows/journal.hpp"
#include "app/study/study_files.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

}  // namespace

Exit report_command(const std::vector<std::string>& folders, const Streams& streams) {
  for (const std::string& folder : folders) {
    // What a study leaves is made from its journal, also of one that was killed.
    if (const fs::path journal = fs::path(folder) / "journal.jsonl"; fs::exists(journal)) {
      JournalContent content = read_journal(journal);
      write_study_files(folder, content);
    }
    streams.out << write_report(folder).string() << '\n';
  }
  return Exit::certified;
}

void add_report(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& c = *line.app.add_subcommand("report", "Rebuild report.html from the files of a run or a study");
  c.add_option("folders", v.configs, "Output folder of a run or a study")->required()->type_name("DIR...");
  c.callback([&] { line.chosen = [&] { return report_command(v.configs, line.streams); }; });
}

}  // namespace leastcost::app
