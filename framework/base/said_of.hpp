// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost {

/// The message of an error about a key, as a sentence: "'target' in ends is the same point as the source". Only a
/// message that does not begin with its verb is set off by a colon: "'steps': number 2 is too small".
std::string said_of(const std::string& subject, const std::string& message);

}  // namespace leastcost
