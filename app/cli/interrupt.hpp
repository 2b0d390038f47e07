// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost::app {

/// From now on the first SIGINT or SIGTERM only sets a flag, so that a run can end with its best path written; the
/// second one ends the program as usual.
void catch_interrupts();
bool interrupted();

/// While it lives, the first request ends the program at once, with exit code 130: files are being read, which takes
/// for ever at a pipe that nobody writes to, and there is nothing yet that could be lost. `out` and `err` are what the
/// two streams are told then. One at a time.
class EndsAtOnce {
 public:
  EndsAtOnce(std::string out, std::string err);
  ~EndsAtOnce();
  EndsAtOnce(const EndsAtOnce&) = delete;
  EndsAtOnce& operator=(const EndsAtOnce&) = delete;

 private:
  std::string out_, err_;
};

}  // namespace leastcost::app
