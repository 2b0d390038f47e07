// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace leastcost::comparison {

/// CPU seconds of this process.
double cpu_seconds();

/// What a function did in a process of its own.
struct Apart {
  std::string text;     ///< what it wrote, also where it did not end well
  bool ended = false;   ///< it came to its end
  bool killed = false;  ///< it used more CPU time than it may
};

/// Runs `work` in a process of its own, which gets at most `most_cpu_seconds`; `write` sends a text back at once.
/// A crash in there ends nothing here. Throws std::runtime_error where no process can be made.
Apart run_apart(double most_cpu_seconds,
                const std::function<void(const std::function<void(const std::string&)>& write)>& work);

/// Megabytes that the process has taken at most since reset_peak_memory(), beyond what it had then; NaN where the
/// system does not say (it is read from /proc).
void reset_peak_memory();
double peak_memory();

}  // namespace leastcost::comparison
