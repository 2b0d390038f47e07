// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace leastcost::app {

/// The 3D view as a script that may stand in a page: app/viewer with three.js, bundled when the program was built.
/// Empty where that was not possible.
std::string_view viewer_script();

}  // namespace leastcost::app
