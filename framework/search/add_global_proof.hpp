// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// A bound of the cost of all paths that is asked for (CertificateOptions::global, a GlobalBudget) is made: where none
/// of the post-processors makes one, the steps that the domain offers come after them. A note says why there are none.
FindOptions with_global_proof(const Problem& problem, const FindOptions& options, std::vector<std::string>& notes);

}  // namespace leastcost
