// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/streams.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace leastcost::app {

Streams standard_streams() {
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const char* const no_color = std::getenv("NO_COLOR");  // https://no-color.org: any value but the empty one
  const char* const term = std::getenv("TERM");
  const bool wanted =
      (no_color == nullptr || *no_color == '\0') && (term == nullptr || std::string_view(term) != "dumb");
  return {std::cout, std::cerr, terminal, terminal && wanted};
}

}  // namespace leastcost::app
