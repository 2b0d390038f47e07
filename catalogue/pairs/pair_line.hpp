// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/catalogue/pairs/pair_result.hpp>

namespace leastcost {

/// A line of paths.jsonl without its line break: one JSON object, the same at every run but for `seconds`. `points`:
/// those of a path are in it.
std::string pair_line(const PairResult& result, bool points);

}  // namespace leastcost
