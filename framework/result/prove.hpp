// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// The tube proof for a result that was certified without one: a run that must be prompt leaves it out
/// (`certificate.proof`: ProofRule::never) and asks for it here, later. The path stays as it is; the certificate gets
/// what find_path() would have given it: `resolution`, the bounds of the least cost in the tube, and the failure
/// `unresolved` where the cost has details that the points did not see. A result without a `resolution` (refused for
/// another reason, or with a path on a bound) and one that is proved already come back unchanged; so does one that the
/// monitor stops, with a note. Throws InputError for a result without a certificate or of
/// another problem, and for a problem without a kernel: give the problem that the search had.
Result prove(const Problem& problem, Result result, const Monitor& monitor = {});

}  // namespace leastcost
