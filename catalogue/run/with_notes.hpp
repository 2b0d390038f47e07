// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost {

/// Why there is no result, with what the user should know about how the configuration was read: the reason may be
/// there, as where a value was taken as "no data".
inline std::string with_notes(std::string message, const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (message.find(note) == std::string::npos) message += "; note: " + note;
  return message;
}

}  // namespace leastcost
