// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include <leastcost/catalogue/pairs/pair_result.hpp>
#include <leastcost/catalogue/run/run.hpp>
#include "catalogue/pairs/pair_reader.hpp"

namespace leastcost {

/// A reader of the file of pairs that the configuration of a run names. Throws InputError.
PairReader reader_of_pairs(const Run& run);

/// solve_pairs() of rows that come from anywhere. `next`: called by one thread at a time; nothing: the end.
bool solve_rows(const Run& run, const std::function<std::optional<PairRow>()>& next, const PairDone& done,
                const PairsOptions& options);

}  // namespace leastcost
