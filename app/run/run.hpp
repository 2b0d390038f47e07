// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>

namespace leastcost::app {

/// Exit codes of the program. That of a finished run follows from its status alone.
enum class Exit {
  certified = 0,
  internal = 1,
  usage = 2,
  configuration = 3,
  input = 4,
  uncertified = 5,
  no_path = 6,
  study_failed = 7,  ///< part of a study
  output = 8,        ///< the host: a disk, a permission, a closed pipe, memory; what was solved is said where it can be
  interrupted = 130
};
Exit exit_of(Status status);

struct RunRequest {
  std::filesystem::path config_file;  ///< "-": standard input
  std::vector<Override> overrides;
  std::filesystem::path output;  ///< empty: that of the configuration, or results/<name>
  bool force = false;
  std::vector<std::string> arguments;  ///< of the program, for the manifest
  BuildProgress building = {};         ///< told how far domains are that take a while to make; may throw StoppedEarly
  EndsFrom ends = EndsFrom::configuration;
};

/// A run whose results, and the report made from them, are on disk.
struct WrittenRun : RunOutcome {
  std::filesystem::path output;  ///< where it was to be written, absolute
  bool in_place = false;         ///< it is there
  std::string output_error;      ///< why not, or what of it is missing; the result stands all the same
};

/// Why an output folder is refused, with what the command line can do about it.
std::string with_advice(const std::string& refusal, bool replaceable);

/// Where the results of a request go.
std::filesystem::path output_of(const RunRequest& request, const Run& run);

/// A configuration before it is read as one.
struct ConfigText {
  std::string text;
  std::string name;              ///< in messages: the file, or "stdin"
  std::filesystem::path folder;  ///< what its files are relative to; empty: the current one
  std::filesystem::path file;    ///< empty for standard input
};

/// The text of a file, or of standard input ("-", or its device), as far as it can be a configuration's. Throws
/// InputError.
ConfigText config_source(const std::filesystem::path& file);

/// load_run() of a file or of standard input.
Run load(const RunRequest& request);

/// solve(), write results and report. Throws InitializationError, StoppedEarly, and OutputError when the output folder
/// cannot be used from the start. Once there is a path nothing is thrown: what goes wrong then is in the outcome.
WrittenRun run(Run loaded, const RunRequest& request, const Monitor& monitor);
/// The same after load(), which throws ConfigError and InputError.
WrittenRun run(const RunRequest& request, const Monitor& monitor);

}  // namespace leastcost::app
