// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/search/find_path.hpp>

#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/result/other_images.hpp>
#include "framework/base/grace_deadline.hpp"
#include "framework/result/never_worse.hpp"
#include "framework/search/add_global_proof.hpp"
#include "framework/search/begin.hpp"
#include "framework/search/run_search.hpp"
#include "framework/search/with_more_points.hpp"

namespace leastcost {
namespace {

/// The search, more points where it lacks them, and nothing worse than where it began. `near`: where the name of the
/// target should be nearest to, where it has several.
Result search_for(const Problem& problem, const Eigen::VectorXd& near, const Begin& begin, const Search& asked) {
  Problem named = problem;
  std::vector<std::string> notes;
  const FindOptions options = with_global_proof(problem, asked.options, notes);
  const Search search{asked.solver, options, asked.monitor, asked.begun};
  if (!search.options.target_as_given && near.size() > 0) name_target_near(near, named);
  Result found = run_search(named, begin, search);
  found = with_more_points(named, std::move(found), search);
  add_notes(notes, found.notes);
  Result best =
      never_worse(named, std::move(found), search.options, grace_deadline(search.monitor.deadline, search.begun, 2));
  // Steps after the solve may have found what was asked for; nothing else would say so then.
  if (best.solve.termination == Termination::refused && best.status == Status::certified)
    best.notes.push_back("the solver " + std::string(search.solver.name()) + " was not used: " + best.solve.message);
  return best;
}

}  // namespace

Result find_path(const Problem& problem, const Initializer& initializer, const Solver& solver,
                 const FindOptions& options, const Monitor& monitor) {
  return search_for(problem, problem.source.u, from_first_path(initializer), {solver, options, monitor});
}

Result improve_path(const Problem& problem, const CoordinatePath& chain, const Solver& solver,
                    const FindOptions& options, const Monitor& monitor) {
  const Eigen::VectorXd end = chain.u.cols() > 0 ? Eigen::VectorXd(chain.u.rightCols(1)) : Eigen::VectorXd();
  return search_for(problem, end, from_chain(chain), {solver, options, monitor});
}

}  // namespace leastcost
