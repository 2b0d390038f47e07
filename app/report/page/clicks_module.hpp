// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace leastcost::app {

/// The searches that answer clicks, as WebAssembly compressed by gzip; empty in a build without (LEASTCOST_CLICKS=OFF).
std::string_view clicks_module();
/// What asks them in a page. Nothing in it ends a script element.
std::string_view clicks_script();

}  // namespace leastcost::app
