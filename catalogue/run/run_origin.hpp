// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run_parts.hpp>
#include "catalogue/config/run_config.hpp"
#include "catalogue/inputs/input_file.hpp"
#include "catalogue/run/pair_composer.hpp"

namespace leastcost {

/// What a run was read from: kept for its files, whatever becomes of the parts.
struct RunOrigin {
  RunConfig config;
  std::filesystem::path folder;   ///< files of the configuration are relative to it
  std::vector<InputFile> inputs;  ///< the configuration, then its data, as they were when they were read
  std::chrono::system_clock::time_point started;
  RunParts parts;                ///< as they were composed
  std::vector<std::string> why;  ///< the methods are what they are, where the configuration left them open
  std::shared_ptr<const PairComposer>
      pairs;  ///< makes the parts for other ends, for many pairs of them; null of a ring
};

}  // namespace leastcost
