// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <leastcost/catalogue/pairs/pair_result.hpp>
#include <leastcost/catalogue/run/run.hpp>

namespace leastcost {

/// One path for each pair, as a run of its own finds it, in the domain of `run`, which is made once. They take the
/// place of the ends that its configuration has; of a configuration with `ends: {pairs: FILE}` the file is not read.
/// max_seconds is that of each pair. What is wrong with a pair is its result; the others are solved all the same.
/// Results do not depend on the threads, but for their seconds. No more than some hundred results per thread are held
/// at any time. Parts of the run that were replaced in memory are used, but for `manifold`. Returns false when it was
/// stopped before the end; those that are missing were not reported. Throws InputError for a ring, and for a run whose
/// manifold was replaced.
bool solve_pairs(const Run& run, std::span<const EndPair> pairs, const PairDone& done,
                 const PairsOptions& options = {});

/// The same for the pairs of the file that the configuration names. Throws InputError where it cannot be read, and
/// where there is none.
bool solve_pairs(const Run& run, const PairDone& done, const PairsOptions& options = {});

}  // namespace leastcost
