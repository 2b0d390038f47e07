// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/placement.hpp"

#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/makes_on_demand.hpp>
#include "framework/domain/in_parts.hpp"
#include "framework/problem/moved_end.hpp"
#include "framework/result/find_path_checks.hpp"

namespace leastcost {
namespace {

/// An end that was given by its coordinates alone, on a domain that has sites: it is found.
void place(const ConstraintManifold& manifold, const char* which, PathEnd& end, std::vector<std::string>& notes,
           const Deadline& deadline) {
  constexpr double kSame = 1e-9;  // of the size of the coordinates: rounding moves no end
  if (end.site != kNoSite || end.u.size() == 0) return;
  double moved = 0;
  if (const auto* parts = find_ability<MakesOnDemand>(manifold); deadline && parts != nullptr) parts->make(deadline);
  const PathEnd found = project_end(manifold, end.u, &moved);
  if (found.site == kNoSite) return;
  end.site = found.site;
  if (moved <= kSame * end.u.cwiseAbs().maxCoeff()) return;
  end.u = found.u;
  notes.push_back(note_of_moved_end(which, moved));
}

}  // namespace

void locate_ends(const Search& search, Outcome& out) {
  Problem& problem = out.problem;
  if (problem.ring && !problem.based) return;
  const Deadline& deadline = search.monitor.limit();
  place(*problem.manifold, "the source", problem.source, out.result.notes, deadline);
  if (!problem.ring) place(*problem.manifold, "the target", problem.target, out.result.notes, deadline);
}

void place_chain(const Problem& problem, CoordinatePath& chain, const Deadline& deadline) {
  constexpr double kSame = 1e-9;
  check_path(problem, chain, problem.ring ? 1 : 3, "the chain");
  pin_ends(problem, chain);
  CoordinatePath placed = chain;
  const Projection projection = project(*problem.manifold, placed, deadline);
  if (!projection.failed.empty())
    throw InputError("column " + std::to_string(projection.failed.front()) +
                     " of the chain has no nearest point on the domain" +
                     reason_for_failure(*problem.manifold, chain.u.col(projection.failed.front())));
  const bool off = projection.moved > kSame * chain.u.cwiseAbs().maxCoeff();
  if (off) chain.u = placed.u;
  chain.sites = std::move(placed.sites);
  pin_ends(problem, chain);
  if (chain.ring || chain.sites.empty()) return;
  chain.sites.front() = problem.source.site;
  chain.sites.back() = problem.target.site;
}

}  // namespace leastcost
