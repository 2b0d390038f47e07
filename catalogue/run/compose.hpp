// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run_config.hpp>
#include <leastcost/framework/family.hpp>
#include <leastcost/framework/find_path.hpp>

namespace leastcost {

/// What became of an end of the configuration.
struct PlacedEnd {
  Eigen::VectorXd given;  ///< the point that was asked for
  PathEnd end;
  double moved = 0;  ///< distance between the two, length units
};

/// The objects that a configuration describes, ready for find_path().
struct Composition {
  Problem problem;
  std::shared_ptr<const Initializer> initializer;
  std::vector<FamilyStart> family;  ///< of all starts, the one above first; empty: only that one
  std::shared_ptr<const Solver> solver;
  FindOptions options;
  PlacedEnd source, target;  ///< empty in a ring
  double read_seconds = 0;   ///< files and their domains
  std::vector<std::string> notes;
};

/// Reads the files, places the ends, makes every object. Throws OptionError whose key is the full path of the option
/// ("ends.source.point"), or InputError.
/// `progress` hears of domains that take a while to make.
Composition compose(const RunConfig& config, const std::filesystem::path& folder, const BuildProgress& progress = {});

/// The same as far as it goes without reading files: finds the errors of options that only constructors check. Adds
/// them to `loaded.errors`.
void check_constructors(LoadedConfig& loaded);

}  // namespace leastcost
