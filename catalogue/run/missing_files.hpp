// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "catalogue/config/loaded_config.hpp"

namespace leastcost {

/// A file that a configuration names and that is not there.
struct MissingFile {
  Place named;       ///< where the configuration names it
  std::string file;  ///< from the current folder
};
std::vector<MissingFile> missing_files(const LoadedConfig& loaded);

}  // namespace leastcost
