// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/geometry/wound.hpp"

#include "problems/geometry/seams.hpp"

namespace leastcost {

std::vector<WoundProblem> wound_problems(const Problem& problem, int turns) {
  std::vector<WoundProblem> all;
  const auto* domain = dynamic_cast<const HasSeams*>(problem.manifold.get());
  if (domain == nullptr || problem.ring) return all;
  const std::vector<Seam>& seams = domain->seams();
  const auto count = static_cast<Index>(seams.size());
  Eigen::VectorXi winding = Eigen::VectorXi::Constant(count, -turns);
  const auto next = [&] {  // counts through all of -turns .. turns
    for (Index s = 0; s < count; ++s) {
      if (++winding[s] <= turns) return true;
      winding[s] = -turns;
    }
    return false;
  };
  do {
    WoundProblem wound{problem, "("};
    wound.problem.target.u = seam_map(seams, static_cast<int>(problem.target.u.size()), winding).apply(problem.target.u);
    for (Index s = 0; s < count; ++s) wound.winding += (s ? ", " : "") + std::to_string(winding[s]);
    wound.winding += ")";
    all.insert(winding.isZero() ? all.begin() : all.end(), std::move(wound));
  } while (next());
  return all;
}

}  // namespace leastcost
