// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// What every step of a search works with. It stays the same through the search.
struct Search {
  const Solver& solver;
  const FindOptions& options;
  const Monitor& monitor;
  Monitor::Clock::time_point begun = Monitor::Clock::now();

  /// Whether a post-processor finds the way by itself, so that any chain is as good a start.
  bool finds_its_own() const;
};

/// What a search has come to so far. Steps change it; a retry makes another one, and the better of the two stays.
struct Outcome {
  Problem asked;    ///< as it was given; its target has the name that the first path leads to
  Problem problem;  ///< prepared: the ends are located, a based ring is cut open. What is sampled, is sampled on this
  Problem solved;   ///< the same on the domain with the margins of the chain that was solved last
  Result result;
  bool sampled = false;     ///< the chain is samples of a path, so that there can be more of them
  Index points = 0;         ///< free points that the search began with
  double depth = 0;         ///< how far the moves of the solved chain go into obstacles
  double depth_before = 0;  ///< and those of the attempt before it went
  bool torn = false;        ///< obstacles keep neighbours of the solved chain far apart (FittedSolve)
  PostProcessed curve = {};
  std::optional<std::string> curve_fault = {};  ///< why a post-processor failed
  std::optional<Index> free_segment = {};       ///< the move that costs nothing, of a path joined at a free place

  /// Whether the cost, or another part of the problem, threw or contradicted itself: then it is not asked again.
  bool failed() const;
};

/// One step of a search. Throws Interrupted.
using Step = void (*)(const Search&, Outcome&);

/// Adds the time of its life to `seconds`, also when an exception ends it.
struct StageTimer {
  explicit StageTimer(double& sum) : seconds(sum) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() { seconds += std::chrono::duration<double>(Monitor::Clock::now() - start).count(); }
  double& seconds;
  Monitor::Clock::time_point start = Monitor::Clock::now();
};

/// Runs a part of a search as one of the stages that an observer sees, and adds up its time, also if it throws.
template <class Work>
void timed(Stage stage, const Search& search, double& seconds, Work work) {
  search.monitor.report({stage, nullptr});
  const StageTimer timer(seconds);
  work();
}

}  // namespace leastcost
