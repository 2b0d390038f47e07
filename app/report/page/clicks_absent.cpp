// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Takes the place of what answers clicks in a build without.
#include "app/report/page/clicks_module.hpp"

namespace leastcost::app {

std::string_view clicks_module() { return {}; }
std::string_view clicks_script() { return {}; }

}  // namespace leastcost::app
