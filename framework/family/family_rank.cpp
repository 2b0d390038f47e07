// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/family/family_rank.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <leastcost/framework/family/same_path.hpp>

namespace leastcost {
namespace {

bool certified(const FamilyMember& m) { return m.result.status == Status::certified; }

int rank_class(const FamilyMember& m) {
  if (m.result.status == Status::collapsed || !std::isfinite(m.rank_cost)) return 3;
  if (m.left) return 2;
  return m.result.status == Status::interrupted ? 1 : 0;
}

bool comes_first(const FamilyMember& a, const FamilyMember& b) {
  const int first = rank_class(a), second = rank_class(b);
  if (first != second) return first < second;
  return a.rank_cost < b.rank_cost;
}

bool overlap(const FamilyMember& a, const FamilyMember& b) {
  const CostRange x = cost_range(a), y = cost_range(b);
  return x.low <= y.high && y.low <= x.high;
}

}  // namespace

CostRange cost_range(const FamilyMember& member) {
  const CostEstimate& e = member.result.certificate.estimate;
  if (!certified(member) || !std::isfinite(e.error)) return {member.rank_cost, member.rank_cost};
  return {e.value - e.error, e.value + e.error};
}

bool is_candidate(const FamilyMember& member) { return rank_class(member) == 0; }

void add_member(FamilyMember member, std::vector<FamilyMember>& members) {
  for (FamilyMember& known : members) {
    if (known.result.status != member.result.status || !same_path(known.problem, known.result.path, member.result.path))
      continue;
    known.origins.insert(known.origins.end(), member.origins.begin(), member.origins.end());
    return;
  }
  members.push_back(std::move(member));
}

void rank_members(std::vector<FamilyMember>& members) {
  std::stable_sort(members.begin(), members.end(), comes_first);
  if (members.empty() || !is_candidate(members.front())) return;
  // The least one may be a certified path once more, solved a little worse: rounding must not decide.
  const auto sure = std::find_if(members.begin(), members.end(), [&](const FamilyMember& m) {
    return certified(m) && is_candidate(m) && cost_range(m).low <= members.front().rank_cost;
  });
  if (sure != members.end()) std::rotate(members.begin(), sure, sure + 1);
  FamilyMember& first = members.front();
  first.tied = false;
  for (auto m = members.begin() + 1; m != members.end(); ++m) {
    m->tied = is_candidate(*m) && overlap(first, *m);
    first.tied = first.tied || m->tied;
  }
}

}  // namespace leastcost
