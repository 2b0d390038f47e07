// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/family/family.hpp>

namespace leastcost {

/// Least and largest cost that a member may have: of a certified one its bar, else only what it is ranked by.
struct CostRange {
  double low, high;
};
CostRange cost_range(const FamilyMember& member);

/// Whether it may be the least path of its family: it is no saddle that was left, no collapsed ring, no unfinished one.
bool is_candidate(const FamilyMember& member);

/// Adds a member (of one origin) to the one that it repeats, or as a new one.
void add_member(FamilyMember member, std::vector<FamilyMember>& members);

/// The order of Family::members, and who is tied.
void rank_members(std::vector<FamilyMember>& members);

}  // namespace leastcost
