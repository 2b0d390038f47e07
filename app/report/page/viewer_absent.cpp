// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Takes the place of the bundled viewer in a build without npm.
#include "app/report/page/viewer_script.hpp"

namespace leastcost::app {

std::string_view viewer_script() { return {}; }

}  // namespace leastcost::app
