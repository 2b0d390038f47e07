// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Under a cost that is zero somewhere (HasFreePlaces) the way by those places competes with every path.

/// A path that has come to a place where moves are free is the way by it: its two parts are joined there.
void join_at_free_place(const Search& search, Outcome& out);

/// A path that keeps away from such places may be the least of its neighbours and dearer than the way by them; a note
/// says so. The spacing of a path that was joined there is that of its parts.
void judge_free_passage(const Search& search, Outcome& out);

}  // namespace leastcost
