// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/report/page/json_file.hpp"

namespace leastcost::app {

/// Which program, on which machine, made these results from what: manifest.json as HTML.
std::string provenance_part(const JsonFile& manifest);

}  // namespace leastcost::app
