// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <leastcost/framework/problem/initializer.hpp>
#include "framework/search/search.hpp"

namespace leastcost {

/// Where a search begins: makes the first path and the chain that is solved first.
using Begin = std::function<void(const Search&, Outcome&)>;

/// From samples of a first path, equally spaced in cost. `initializer` must outlive it.
Begin from_first_path(const Initializer& initializer);

/// From a chain as it is. `chain` must outlive it.
Begin from_chain(const CoordinatePath& chain);

}  // namespace leastcost
