// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/problem/moved_end.hpp"

#include "framework/base/point_text.hpp"

namespace leastcost {

std::string note_of_moved_end(const std::string& which, double moved) {
  return which + " is " + short_number(moved) + " from the domain; the path has its nearest point on it";
}

}  // namespace leastcost
