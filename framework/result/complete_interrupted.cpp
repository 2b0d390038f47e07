// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/result/complete_interrupted.hpp>

#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/base/counted.hpp"
#include "framework/result/delivery.hpp"
#include "framework/result/find_path_checks.hpp"
#include "framework/result/never_worse.hpp"

namespace leastcost {

void complete_interrupted(const Problem& problem, const FindOptions& options, Result& result) {
  if (result.status != Status::interrupted || result.post_processed || result.path.u.size() == 0) return;
  check(problem);
  check(options);
  if (result.path.u.rows() != problem.manifold->dimensions().coordinate)  // (a based ring is open in its result)
    throw InputError("the path has " + counted(result.path.u.rows(), "coordinate") + ", but the domain has " +
                     std::to_string(problem.manifold->dimensions().coordinate));
  Monitor stopped;  // post-processors that improve a path step by step return at once
  stopped.stop_requested = [] { return true; };
  PathEnergy energy(problem, 1);
  try {
    PostProcessed processed = chain_as_curve(energy, result.path);
    if (const auto fault = post_process_or_say_why(problem, result.first, options, stopped, processed))
      processed.notes.push_back("the curve was left unchanged: " + *fault);
    deliver(processed, energy.costs(processed.chain), result);
    result.post_processed = true;
  } catch (const Interrupted&) {
    const PostProcessed chain = chain_as_curve(energy, result.path);
    deliver(chain, chain.curve_costs, result);
  }
  result = never_worse(problem, std::move(result), options, {});
}

}  // namespace leastcost
