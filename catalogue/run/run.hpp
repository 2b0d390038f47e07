// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run_parts.hpp>
#include <leastcost/framework/base/errors.hpp>

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
  std::string name;                         ///< of the configuration; the default name of the output folder
  RunParts parts;                           ///< what find_path() is called with
  std::optional<double> max_seconds;        ///< time budget of solve(), s
  RunSeconds seconds;                       ///< spent before the search
  std::shared_ptr<const RunOrigin> origin;  ///< what was read, for the files of results
};

/// A finished run.
struct RunOutcome {
  std::string name;  ///< of the configuration
  RunParts parts;    ///< with the target that was reached: of a family perhaps another image of the same point
  Result result;     ///< the path with its certificate
  std::vector<FamilyMember> family;                ///< distinct paths, the delivered one first; empty without a family
  std::optional<Waypoints> waypoints;              ///< where they were asked for
  std::optional<Trajectory> trajectory;            ///< the same
  std::vector<std::string> replaced;               ///< parts that are not as they were read, in words: "cost", "ends"
  RunSeconds seconds;                              ///< spent on every stage
  std::chrono::system_clock::time_point finished;  ///< when the search ended
  std::shared_ptr<const RunOrigin> origin;         ///< the configuration and the files that the run came from
};

}  // namespace leastcost
