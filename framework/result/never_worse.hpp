// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// Whether what straight moves cost is what the path costs: a flat domain, among obstacles or not, and a cost that adds
/// up along a move.
bool moves_are_exact(const Problem& problem);

/// Whether the first path is clearer of the obstacles than what a search came to, or as clear and cheaper. Only costs
/// and clearances of curves on the domain are compared; what cannot be measured is never better. Throws Interrupted.
bool first_path_is_better(const Problem& problem, const Result& result, const FindOptions& options,
                          const Deadline& deadline);

/// The last step of every search: what it delivers is never dearer and never less clear than its first path. Where the
/// search came to less, the first path is delivered with its own cost and clearance, and a note says so: its samples,
/// or its own points where moves between the samples would touch an obstacle or leave a mesh. The failures of the path
/// that was searched stay, so the result is not certified. After the deadline an interrupted search among obstacles
/// delivers its first path, too, unless that touches one, and elsewhere the one of the two whose moves cost less.
/// `problem` is the one that was given to the search.
Result never_worse(const Problem& problem, Result result, const FindOptions& options, const Deadline& deadline);

}  // namespace leastcost
