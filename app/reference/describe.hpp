// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catalogue/plugins/plugin.hpp"

namespace leastcost::app {

/// Every option of a plug-in with its type, default, unit, range and one sentence.
std::string describe_plugin(const PluginKind& kind, const PluginEntry& plugin);
/// All types of a kind with their summaries.
std::string describe_kind(const PluginKind& kind);
/// The keys of a configuration.
std::string describe_run();

/// The keys of a study.
std::string describe_study();

/// JSON Schema (draft 7) of a configuration or a study, for completion and checks in an editor.
std::string json_schema();

}  // namespace leastcost::app
