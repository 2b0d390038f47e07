// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include <leastcost/problems/drawing/draws_poses.hpp>

namespace leastcost {

/// A robot in space and its obstacles as JSON text, with lengths to five digits of the size of the scene.
std::string workspace_json(const Workspace& workspace);
/// The inverse. Throws InputError, and what the JSON library throws.
Workspace read_workspace(const nlohmann::json& json);

}  // namespace leastcost
