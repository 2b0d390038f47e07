// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace leastcost::app {

/// What `describe` prints, as pages of Markdown: one for each plug-in ("cost/travel_time.md"), one for each kind
/// ("costs.md"), run.md and study.md. Keys are file names, values texts; links between the pages are relative.
std::map<std::string, std::string> reference_pages();

}  // namespace leastcost::app
