// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/catalogue/plugins/externals.hpp>
#include "catalogue/config/run_config.hpp"
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// The plug-ins that a configuration leaves out. The recipes choose; what they choose is written down as if it had been
/// asked for.
void fill_defaults(RunConfig& config);

/// Gives a kernel, initializer or solver the type that is the default, where an override names one of its options and
/// nothing its type: `--set solver.max_iterations=50`.
void complete_types(ConfigNode& tree, const Externals& externals);

}  // namespace leastcost
