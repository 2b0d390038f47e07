// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/family/family.hpp>

namespace leastcost {

/// Decides about the members that seem cheaper than every certified one: solves them again with twice the points until
/// they are certified, and leaves saddles to their lower side; then tries the proof of the least one, and decides anew
/// where that is refuted. Returns notes on what stayed undecided. The members are ranked afterwards.
std::vector<std::string> decide_family(std::vector<FamilyMember>& members, const Solver& solver,
                                       const FindOptions& options, const Monitor& monitor);

}  // namespace leastcost
