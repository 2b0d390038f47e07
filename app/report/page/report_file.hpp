// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost {

/// One file of a report.
struct ReportFile {
  std::string name;     ///< relative to the folder of the results
  std::string content;  ///< bytes of the file
};

}  // namespace leastcost
