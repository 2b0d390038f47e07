// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Whether the straight moves of a chain are known to touch nothing.
bool are_clear(const Problem& problem, const CoordinatePath& chain, double allowed, const Deadline& deadline);

/// Among obstacles few points keep a distance that makes the moves between them clear, and may cost more than the first
/// path though the path that they stand for, which is certified, does not. Such points are not delivered.
void refuse_dearer(const Problem& problem, const Search& search, Result& result);

}  // namespace leastcost
