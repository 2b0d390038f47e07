// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/result/prove.hpp>

#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/certificate/resolution.hpp>
#include <leastcost/framework/newton/refinement.hpp>
#include "framework/result/find_path_checks.hpp"

namespace leastcost {

Result prove(const Problem& problem, Result result, const Monitor& monitor) {
  Certificate& certificate = result.certificate;
  if (!certificate.measured)
    throw InputError(
        "prove() needs a result with a certificate: set certificate.enabled in the options of find_path()");
  check(problem);
  check_path(problem, result.path, problem.ring ? 1 : 2, "the path of the result");
  if (!certificate.resolution || certificate.resolution->minimum_proved) return result;
  try {
    const Refinement refinement = refine_levels(problem, result.path, monitor);
    if (!refinement.trouble.empty()) return result;
    CostEstimate estimate = certificate.estimate;
    ExaminedResolution examined =
        examine_resolution(problem, result.path, refinement, ProofEffort::insist, estimate, monitor);
    certificate.estimate = estimate;
    certificate.resolution = examined.resolution;
    if (certificate.resolution->minimum_proved) certificate.failures.clear();
    for (CertificateFailure& failure : examined.failures) certificate.failures.push_back(std::move(failure));
  } catch (const Interrupted&) {
    add_notes({"there was no time for the proof of the minimum: call prove() again with more"}, result.notes);
    return result;
  }
  if (result.status == Status::certified || result.status == Status::uncertified)
    result.status = certificate.certified() ? Status::certified : Status::uncertified;
  return result;
}

}  // namespace leastcost
