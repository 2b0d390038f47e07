// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/compose.hpp"
#include "app/config/overrides.hpp"
#include "framework/errors.hpp"
#include "framework/find_path.hpp"

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
  interrupted = 130
};
Exit exit_of(Status status);

/// Stopped, by request or by max_seconds, before there was a first path.
class StoppedEarly : public InitializationError {
 public:
  using InitializationError::InitializationError;
};

struct RunRequest {
  std::filesystem::path config_file;
  std::vector<Override> overrides;
  std::filesystem::path output;  ///< empty: that of the configuration, or results/<name>
  bool force = false;
  std::vector<std::string> arguments;  ///< of the program, for the manifest
  BuildProgress building = {};         ///< told how far domains are that take a while to make; may throw StoppedEarly
};

/// A finished run.
struct RunOutcome {
  RunConfig config;
  Composition parts;
  Result result;
  std::vector<FamilyMember> family;  ///< distinct paths, the delivered one first; empty without a family
  std::filesystem::path output;      ///< where it was written, absolute
  std::string output_error;          ///< why it could not be written; the result stands all the same
};

/// A configuration that is ready to run: composed, nothing solved, nothing written.
struct Prepared {
  LoadedConfig loaded;
  Composition parts;
};

/// Reads, checks and composes; all files of the configuration have been read afterwards. Throws ConfigError,
/// InputError.
Prepared prepare(const RunRequest& request);

/// The search of a composed configuration, within its max_seconds: the path, or the best of its family. Writes nothing. Throws
/// InitializationError; StoppedEarly when it was told to stop before there was a first path.
RunOutcome solve(RunConfig config, Composition parts, const Monitor& monitor);

/// Where the results of a request go.
std::filesystem::path output_of(const RunRequest& request, const RunConfig& config);

/// prepare(), find_path(), write. Throws ConfigError, InputError, InitializationError, and OutputError when the output
/// folder cannot be used from the start.
RunOutcome run(const RunRequest& request, const Monitor& monitor);

}  // namespace leastcost::app
