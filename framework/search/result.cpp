// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/search/result.hpp>

namespace leastcost {

std::string_view name(Status status) {
  switch (status) {
    case Status::certified: return "certified";
    case Status::uncertified: return "uncertified";
    case Status::collapsed: return "collapsed";
    case Status::interrupted: return "interrupted";
  }
  return "unknown";
}

}  // namespace leastcost
