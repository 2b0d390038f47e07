// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// A ring with a fixed point is an open path from that point to an image of itself: its first path is cut open beside
/// the point and led through it. Other problems stay as they are.
void cut_at_base(Outcome& out);

/// The same for a chain to begin with. A result of such a search is open already, and ends at the image that it found.
void open_based_chain(Outcome& out);

}  // namespace leastcost
