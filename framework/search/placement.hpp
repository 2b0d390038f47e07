// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include "framework/search/search.hpp"

namespace leastcost {

/// Ends that know their sites, on a domain that has some: one that was given by its coordinates alone is found, and a
/// note says where it was moved. Throws Interrupted.
void locate_ends(const Search& search, Outcome& out);

/// Puts a chain that somebody made between the ends of the problem and onto the domain. Throws InputError when sizes or
/// numbers do not fit or a point has no nearest one on the domain, Interrupted.
void place_chain(const Problem& problem, CoordinatePath& chain, const Deadline& deadline);

}  // namespace leastcost
