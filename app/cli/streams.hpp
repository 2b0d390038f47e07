// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>

namespace leastcost::app {

/// Where a command writes: `out` carries the result and nothing else, `err` errors, log and progress.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;
  bool color = false;  ///< of errors; off with NO_COLOR
};

/// cout and cerr, with what the terminal and the environment say about them.
Streams standard_streams();

}  // namespace leastcost::app
