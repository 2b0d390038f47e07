// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost {

/// What a user should know of an end that was given `moved` from the domain: `which` is "the source" or "the target".
std::string note_of_moved_end(const std::string& which, double moved);

}  // namespace leastcost
