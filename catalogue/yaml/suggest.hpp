// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace leastcost {

/// The candidate that `word` was probably meant to be, or an empty string when none is near enough.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)", or an empty string.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c".
std::string joined(const std::vector<std::string>& words);

}  // namespace leastcost
