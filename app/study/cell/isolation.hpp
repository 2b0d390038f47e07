// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace leastcost::app {

/// One piece of work that is done in a process of its own.
struct IsolatedJob {
  std::function<std::string()> work;  ///< what it returns reaches the parent; runs in the child
  double max_seconds = 0;             ///< then the child is killed; 0: never
  int max_memory = 0;                 ///< MB of address space; 0: no limit
};

/// How such a child ended.
struct IsolatedEnd {
  enum class How { done, crash, timeout, memory, error };
  How how = How::error;
  std::string text;  ///< done: what the work returned; else what happened, in words
};

struct IsolatedJobs {
  std::size_t count = 0;
  std::function<IsolatedJob(std::size_t)> job;
  std::function<void(std::size_t, IsolatedEnd)> ended;  ///< called in the parent, in the order in which they end
  std::function<bool()> stop_requested;                 ///< may be empty
  int parallel = 1;
};

/// Runs the jobs in forked children, started in their order, at most `parallel` at once. A child that crashes, hangs or
/// runs out of memory is an end like any other. Children die with their parent, ignore Ctrl-C, which is for the parent,
/// and print nothing: what they say on stdout and stderr is quoted when they crash. Call it from a process with one
/// thread. Returns false when it was stopped: the children are then dead, and nothing is said of them.
bool run_isolated(const IsolatedJobs& jobs);

/// Whether max_memory can work in this build: the sanitizers map more address space than there is.
bool can_limit_memory();

}  // namespace leastcost::app
