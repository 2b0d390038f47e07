// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <vector>

#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/progress.hpp"
#include "app/pairs/run_pairs.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/output_folder.hpp"
#include "catalogue/run/run_origin.hpp"

namespace leastcost::app {
namespace {

std::string words_of(const std::map<std::string, long>& counts) {
  std::vector<std::string> words;
  words.reserve(counts.size());
  for (const auto& [word, count] : counts) words.push_back(fmt::format("{} {}", count, word));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string spectrum_line(const char* label, const Spectrum& spectrum, const char* unit) {
  if (spectrum.empty()) return "";
  return fmt::format("{:<11} median {:.2g}{}, worst {:.2g}{} (pair {})\n", label, spectrum.median(), unit,
                     spectrum.greatest(), unit, spectrum.greatest_of());
}

std::string pairs_text(const PairsOutcome& outcome) {
  const PairSummary& summary = outcome.summary;
  std::string out = fmt::format("{:<11} {}: {}\n", "pairs", summary.count, words_of(summary.outcomes));
  if (!summary.proofs.empty()) out += fmt::format("{:<11} {}\n", "proofs", words_of(summary.proofs));
  out += spectrum_line("error", summary.errors, " of the cost");
  out += spectrum_line("seconds", summary.seconds, " s");
  for (const std::string& note : outcome.notes) out += fmt::format("{:<11} {}\n", "note", note);
  const long done = summary.count - outcome.found;
  out += fmt::format("{:<11} read {:.3g} s, compose {:.3g} s, {} pairs {:.3g} s with {} thread{}", "time",
                     outcome.seconds.read, outcome.seconds.compose, done, outcome.seconds.search, outcome.threads,
                     outcome.threads == 1 ? "" : "s");
  if (outcome.found > 0) out += fmt::format("; {} already done", outcome.found);
  return out + fmt::format("\n{:<11} {}\n", "output", outcome.output.string());
}

std::string pairs_json(const PairsOutcome& outcome, const std::string& name) {
  nlohmann::ordered_json out = nlohmann::ordered_json::parse(result_json(outcome, name));
  out["output"] = outcome.output.string();
  return to_text(out);
}

Exit pairs_dry_run(const Run& run, const RunArguments& arguments, const Streams& streams) {
  const PairsLook look = look_at_pairs(run);
  const std::string output = output_of(arguments.request, run).string();
  if (arguments.json || arguments.json_lines) {
    streams.out << to_text({{"schema_version", kSchemaVersion},
                            {"status", "dry_run"},
                            {"name", run.name},
                            {"pairs", look.count},
                            {"faulty", look.faulty},
                            {"first_fault", look.first_fault},
                            {"output", output}});
    return Exit::certified;
  }
  streams.out << fmt::format("{:<11} {}\n{:<11} {} of {}, {} of them invalid{}\n{:<11} {}\n", "valid",
                             arguments.request.config_file.string(), "pairs", look.count,
                             look.by_number ? "vertices" : "points", look.faulty,
                             look.first_fault.empty() ? "" : " (" + look.first_fault + ")", "would write", output);
  return Exit::certified;
}

/// Of all pairs: a pair without a path outweighs one that is not certified.
Exit exit_of(const PairsOutcome& outcome) {
  if (outcome.interrupted) return Exit::interrupted;
  if (outcome.summary.failed() > 0) return Exit::study_failed;
  return outcome.summary.all_certified() ? Exit::certified : Exit::uncertified;
}

}  // namespace

Exit pairs_command(const Run& run, const RunArguments& arguments, const Streams& streams) {
  if (arguments.dry_run) return pairs_dry_run(run, arguments, streams);
  ProgressPrinter progress(streams, arguments.verbosity == Verbosity::quiet);
  PairsRequest request;
  request.run = arguments.request;
  request.resume = arguments.resume;
  request.threads = arguments.threads;
  request.stop_requested = interrupted;
  request.observe = [&](const PairProgress& p) { progress.show_part("pairs", p.part, fmt::format("{}", p.finished)); };
  if (arguments.json_lines) {
    request.line = [&](const std::string& text, bool written) {
      streams.out << text;
      if (written) streams.out << std::flush;
      if (!streams.out) throw OutputError("cannot write to standard output");
    };
  }
  const PairsOutcome outcome = run_pairs(run, request);
  progress.clear();
  if (arguments.json) streams.out << pairs_json(outcome, run.name);
  // The lines have standard output to themselves.
  if (!arguments.json) (arguments.json_lines ? streams.err : streams.out) << pairs_text(outcome);
  if (outcome.interrupted)
    streams.err << fmt::format("interrupted: {} pairs are done; to continue, add --resume to the same command\n",
                               outcome.summary.count);
  return exit_of(outcome);
}

}  // namespace leastcost::app
