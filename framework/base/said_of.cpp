// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/base/said_of.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace leastcost {

std::string said_of(const std::string& subject, const std::string& message) {
  static constexpr std::array<std::string_view, 8> kVerbs = {"is",   "are",   "has",  "have",
                                                             "must", "needs", "does", "cannot"};
  const std::string_view first = std::string_view(message).substr(0, message.find(' '));
  return subject + (std::find(kVerbs.begin(), kVerbs.end(), first) != kVerbs.end() ? " " : ": ") + message;
}

}  // namespace leastcost
