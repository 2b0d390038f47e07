// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/compose.hpp>
#include <leastcost/catalogue/yaml/overrides.hpp>
#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/find_path.hpp>

namespace leastcost {

/// Stopped, by request or by max_seconds, before there was a path: a result of find_path() that is interrupted and
/// empty, of which nothing can be written.
class StoppedEarly : public Error {
 public:
  using Error::Error;
};

/// A configuration and the objects it describes: nothing solved, nothing written. `parts` may be changed before
/// solve(); the files that write_results() makes then describe what was solved, and config.resolved.yaml what was read.
struct Run {
  LoadedConfig loaded;
  Composition parts;
};

/// Reads, checks and composes; all files of the configuration have been read afterwards. `progress` hears of domains
/// that take a while to make. Throws ConfigError with every error and its place, InputError.
Run load_run(const std::filesystem::path& file, const std::vector<Override>& overrides = {},
             const BuildProgress& progress = {});

/// A finished run.
struct RunOutcome {
  RunConfig config;
  Composition parts;
  Result result;
  std::vector<FamilyMember> family;  ///< distinct paths, the delivered one first; empty without a family
};

/// The search of a composed configuration, within its max_seconds: the path, or the best of its family. Writes nothing.
/// What an interrupted search had no time for, its curve and its costs, is made up for afterwards. Throws
/// InitializationError; StoppedEarly when it was told to stop before there was a path.
RunOutcome solve(RunConfig config, Composition parts, const Monitor& monitor = {});

}  // namespace leastcost
