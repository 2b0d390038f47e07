// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/search/find_path.hpp>

namespace leastcost {

/// The least-cost path of a problem by the methods that are recommended for it, with the proof over all paths if there
/// is one: see recommended(). If problem.kernel is null, exp(s^2) - 1 is used; `problem` itself is not changed.
/// Where the first path is straight and the cost may make another way cheaper, a few bows are tried, unless there is a
/// deadline, and a note of the result names one that costs less (look_elsewhere). Post-processors of `options` come
/// first; a recommended one of the same name is then left out. Throws as find_path() with parts of your own, and
/// InputError for a ring, which has no default first path.
Result find_path(const Problem& problem, const FindOptions& options = {}, const Monitor& monitor = {});

}  // namespace leastcost
