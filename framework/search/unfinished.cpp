// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/unfinished.hpp"

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/base/grace_deadline.hpp"
#include "framework/result/delivery.hpp"

namespace leastcost {

void leave_unmeasured(Outcome& out) {
  Result& result = out.result;
  deliver_unmeasured(result);
  result.curve.x = PathEnergy(out.problem, 1).ambient(result.path).x;
  const bool threw = result.solve.termination == Termination::exception;
  result.certificate.failures.push_back(
      {threw ? Failure::exception : Failure::inconsistent, "while solving: " + result.solve.message});
}

void leave_unfinished(const Search& search, const std::string& why, Outcome& out) {
  Result& result = out.result;
  result.status = Status::interrupted;
  if (result.post_processed) return;
  if (search.options.certificate.enabled)
    result.certificate.failures.push_back({Failure::interrupted, "there was no time for the certificate"});
  if (result.path.u.size() == 0) {
    result.notes.push_back("interrupted before a path was found: " + why);
    return;
  }
  deliver_unmeasured(result);
  try {
    PathEnergy energy(out.problem, 1, grace_deadline(search.monitor.deadline, search.begun, 1));
    const PostProcessed chain = chain_as_curve(energy, result.path);
    deliver(chain, chain.curve_costs, result);
  } catch (const Interrupted&) {
    result.notes.emplace_back("interrupted: there was no time to measure the path");
  }
}

}  // namespace leastcost
