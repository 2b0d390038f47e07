// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost {

/// One option of a configuration that is replaced or added after reading: {"solver.max_iterations=50"}.
struct Override {
  std::string assignment;   ///< "key=value", the value in YAML
  std::string origin = {};  ///< shown in messages in the place of file:line:column; empty: the assignment
};

}  // namespace leastcost
