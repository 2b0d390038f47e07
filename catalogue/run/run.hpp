// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run_parts.hpp>
#include <leastcost/catalogue/yaml/diagnostics.hpp>
#include <leastcost/catalogue/yaml/override.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/distance/build_progress.hpp>

namespace leastcost {

/// Stopped, by request or by max_seconds, before there was a path: a result of find_path() that is interrupted and
/// empty, of which nothing can be written.
class StoppedEarly : public Error {
 public:
  using Error::Error;
};

/// Wall time of what is not the search for one path (Result::seconds), s.
struct RunSeconds {
  double read = 0;     ///< the files that the configuration names, and the domains made from them
  double compose = 0;  ///< everything else that load_run() does
  double search = 0;   ///< solve() as a whole, all members of a family included
  double write = 0;    ///< the files of results
  double report = 0;   ///< what the command line program adds to them
};

struct RunOrigin;

/// A configuration that was read, and the objects it describes: nothing solved, nothing written. All but `origin` may
/// be changed before solve(); the files of results then describe what was solved and name the parts that were replaced.
struct Run {
  std::string name;
  RunParts parts;
  std::optional<double> max_seconds;  ///< time budget of solve(), s
  RunSeconds seconds;
  std::shared_ptr<const RunOrigin> origin;  ///< what was read, for the files of results
};

/// Reads, checks and composes; all files of the configuration have been read afterwards. `progress` hears of domains
/// that take a while to make, and may throw to stop. Throws ConfigError with every error and its place, InputError.
Run load_run(const std::filesystem::path& file, const std::vector<Override>& overrides = {},
             const BuildProgress& progress = {});

/// The same for a configuration that is in memory. `name`: what messages call it, and the default name of the run;
/// `folder`: what its files are relative to, empty for the current one.
Run parse_run(std::string text, const std::string& name, const std::filesystem::path& folder = {},
              const std::vector<Override>& overrides = {}, const BuildProgress& progress = {});

/// A finished run.
struct RunOutcome {
  std::string name;
  RunParts parts;  ///< with the target that was reached: of a family perhaps another image of the same point
  Result result;
  std::vector<FamilyMember> family;    ///< distinct paths, the delivered one first; empty without a family
  std::optional<Waypoints> waypoints;  ///< where they were asked for
  std::vector<std::string> replaced;   ///< parts that are not as they were read, in words: "cost", "ends"
  RunSeconds seconds;
  std::chrono::system_clock::time_point finished;
  std::shared_ptr<const RunOrigin> origin;
};

/// The search of a composed configuration, within its max_seconds: the path, or the best of its family. Writes nothing.
/// What an interrupted search had no time for, its curve and its costs, is made up for afterwards. Throws
/// InitializationError; StoppedEarly when it was told to stop before there was a path.
RunOutcome solve(Run run, const Monitor& monitor = {});

}  // namespace leastcost
