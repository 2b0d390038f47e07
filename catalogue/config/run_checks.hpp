// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catalogue/config/loaded_config.hpp"

namespace leastcost {

/// Why a name cannot be that of a folder; empty when it can.
std::string name_fault(const std::string& name);

/// Fills in the plug-ins that the configuration leaves out and checks what no single option can: that the parts fit
/// each other.
void check_and_complete(LoadedConfig& loaded);

}  // namespace leastcost
