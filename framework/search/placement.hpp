// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// The problem with ends that know their sites, on a domain that has some: one that was given by its coordinates alone
/// is found, and a note says where it was moved. Throws Interrupted.
Problem with_sites(Problem problem, std::vector<std::string>& notes, const Deadline& deadline = {});

/// Puts a chain that somebody made between the ends of the problem and onto the domain. Throws InputError when sizes or
/// numbers do not fit or a point has no nearest one on the domain, Interrupted.
void place_chain(const Problem& problem, CoordinatePath& chain, const Deadline& deadline);

}  // namespace leastcost
