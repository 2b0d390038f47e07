// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include <leastcost/framework/base/said_of.hpp>
#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/summary.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/output_folder.hpp"
#include "catalogue/run/run_origin.hpp"
#include "problems/fields/no_way.hpp"

namespace leastcost::app {
namespace {

std::string error_label(const Streams& streams) { return streams.color ? "\033[1;31merror:\033[0m" : "error:"; }

/// Whether options that only a run of many pairs has are given to one without.
bool misses_pairs(const RunArguments& arguments, const Run& run, const Streams& streams) {
  if (run.origin->config.has_pairs() || !(arguments.json_lines || arguments.resume || arguments.threads > 1))
    return false;
  streams.err << error_label(streams)
              << " --resume, -j and --format jsonl are for runs of many pairs of ends: add --pairs FILE, or ends: "
                 "{pairs: FILE} in the configuration\n";
  return true;
}

Exit dry_run(const RunArguments& arguments, const Streams& streams) {
  const Run prepared = load(arguments.request);
  if (misses_pairs(arguments, prepared, streams)) return Exit::usage;
  if (prepared.origin->config.has_pairs()) return pairs_command(prepared, arguments, streams);
  streams.out << (arguments.json ? dry_run_json(arguments.request, prepared)
                                 : dry_run_text(arguments.request, prepared));
  return Exit::certified;
}

/// A run without a result still gives a program one object to read.
std::string without_result(bool json, const char* status, const std::string& message) {
  if (!json) return "";
  const nlohmann::ordered_json out = {
      {"schema_version", kSchemaVersion}, {"status", status}, {"certified", false}, {"message", message}};
  return to_text(out);
}

/// Reads the files and makes the domain; an interrupt then ends the program at once.
Run load_or_end(const RunRequest& request, bool json, const Streams& streams) {
  const std::string message = "interrupted before a path was found";
  const EndsAtOnce reading(without_result(json, "interrupted", message),
                           (streams.err_is_terminal ? "\r\033[K" : "") + message + "; nothing was written\n");
  return load(request);
}

/// What an exception means for the program: exit code, status for programs, message for people.
struct Verdict {
  Exit exit;
  const char* status;
  std::string reason, message;
};

Verdict verdict_on_exception(const Streams& streams) {
  const auto verdict = [&](Exit exit, const char* status, const std::string& reason, const char* before = "",
                           const char* after = "") {
    return Verdict{exit, status, reason, fmt::format("{} {}{}{}\n", error_label(streams), before, reason, after)};
  };
  try {
    throw;
  } catch (const ConfigError& e) {
    const Diagnostics& d = e.diagnostics();
    return {Exit::configuration, "configuration_error", e.what(), d.render(streams.color) + d.count() + "\n"};
  } catch (const OptionError& e) {
    return verdict(Exit::configuration, "configuration_error", said_of(in_quotes(e.key()), e.reason()));
  } catch (const NoWay& e) {
    return verdict(Exit::no_path, "no_path", e.what());
  } catch (const InputError& e) {
    return verdict(Exit::input, "input_error", e.what());
  } catch (const InitializationError& e) {
    return verdict(Exit::no_path, "no_path", e.what(), "no path: ");
  } catch (const OutputRefused& e) {
    return verdict(Exit::usage, "output_refused", with_advice(e.what(), e.replaceable()));
  } catch (const HostError& e) {
    return verdict(Exit::output, "output_error", e.what());
  } catch (const std::filesystem::filesystem_error& e) {
    return verdict(Exit::output, "output_error", e.path1().string() + ": " + e.code().message());
  } catch (const std::bad_alloc&) {
    return verdict(Exit::output, "out_of_memory", "not enough memory");
  } catch (const std::exception& e) {
    return verdict(Exit::internal, "internal_error", e.what(), "internal: ", " (please report this)");
  } catch (...) {
    return verdict(Exit::internal, "internal_error", "an unknown exception", "internal: ", " (please report this)");
  }
}

constexpr const char* kPairsHelp =
    "Many pairs of ends: a CSV file, one pair per line. The header is source,target for vertex numbers, or\n"
    "source_x,source_y,..,target_x,.. for points, with the coordinate names of the domain. Other columns are ignored.\n"
    "Each pair, valid or not, becomes one line of paths.jsonl, in the order of the file.";

}  // namespace

Exit run_command(const RunArguments& arguments, const Streams& streams) {
  if (arguments.dry_run) return dry_run(arguments, streams);
  catch_interrupts();
  ProgressPrinter progress(streams, arguments.verbosity == Verbosity::quiet);
  Monitor monitor;
  monitor.observe = [&](const Progress& p) { progress.show(p); };
  monitor.stop_requested = interrupted;
  RunRequest request = arguments.request;
  request.building = [&](double part, std::string_view phase) { progress.show_building(part, phase); };
  try {
    Run loaded = load_or_end(request, arguments.json, streams);
    if (misses_pairs(arguments, loaded, streams)) return Exit::usage;
    if (loaded.origin->config.has_pairs()) {
      progress.clear();
      return pairs_command(loaded, arguments, streams);
    }
    const WrittenRun outcome = run(std::move(loaded), request, monitor);
    progress.clear();
    streams.out << (arguments.json ? summary_json(outcome)
                                   : summary_text(outcome, arguments.verbosity == Verbosity::verbose))
                << std::flush;
    if (outcome.output_error.empty()) return exit_of(outcome.result.status);
    streams.err << error_label(streams)
                << (outcome.in_place ? " not all files could be written: "
                                     : " the results are not in the requested folder: ")
                << outcome.output_error << '\n';
    return Exit::output;
  } catch (const StoppedEarly& e) {
    progress.clear();
    streams.err << e.what() << "; nothing was written\n";
    streams.out << without_result(arguments.json, "interrupted", e.what());
    return Exit::interrupted;
  }
}

Exit exit_of_exception(const Streams& streams, bool json) {
  const Verdict verdict = verdict_on_exception(streams);
  streams.err << verdict.message;
  streams.out << without_result(json, verdict.status, verdict.reason);
  return verdict.exit;
}

void add_run(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& c = *line.app.add_subcommand(
      "run", "Find a least-cost path, or one for each of many pairs of ends, and write the results");
  c.footer(kPairsHelp);
  c.add_option("config", v.config,
               "Configuration (YAML); - reads standard input, with files relative to the current folder")
      ->required()
      ->type_name("CONFIG");
  add_set(c, v);
  c.add_option("--format", v.format, "text or json; with many pairs also jsonl: the lines of paths.jsonl")
      ->check(CLI::IsMember({"text", "json", "jsonl"}))
      ->type_name("FORMAT");
  add_output(c, v, "Output folder; default: results/<name>", "DIR");
  c.add_option("--pairs", v.pairs, "Find a path for each pair in this CSV file, instead of the configuration's ends")
      ->type_name("FILE")
      ->check(empty_fault);
  c.add_option("-j,--jobs", v.parallel, "With many pairs: number of threads")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  auto* resume = c.add_flag("--resume", v.resume, "With many pairs: resume an interrupted or killed run");
  c.add_flag("--force", v.force, "Replace the output folder of an earlier run")->excludes(resume);
  c.add_flag("-n,--dry-run", v.dry_run,
             "Check everything, including input files, and print the plan; solve and write nothing");
  auto* quiet = c.add_flag("-q,--quiet", v.quiet, "Print no progress");
  c.add_flag("-v,--verbose", v.verbose, "Print more about the result")->excludes(quiet);
  c.callback([&] {
    line.chosen = [&] {
      RunArguments run{
          {v.config, v.overrides(), v.output, v.force, line.arguments}, v.dry_run, v.json(), Verbosity::normal};
      if (v.quiet) run.verbosity = Verbosity::quiet;
      if (v.verbose) run.verbosity = Verbosity::verbose;
      run.json_lines = v.json_lines();
      run.resume = v.resume;
      run.threads = v.parallel;
      return run_command(run, line.streams);
    };
  });
}

}  // namespace leastcost::app
