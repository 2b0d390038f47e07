// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/search/find_path.hpp>

namespace leastcost {

/// The least-cost path of a problem by the methods that are recommended for it: what a configuration without further
/// options runs, the proof over all paths included where there is one (see recommended()). A kernel that is missing is
/// that of the defaults, exp(s^2) - 1. Post-processors of `options` come before the recommended ones, which are left
/// out where one of the same name is given. Throws as find_path() with parts of your own, and InputError for a ring,
/// which has no default first path.
Result find_path(const Problem& problem, const FindOptions& options = {}, const Monitor& monitor = {});

}  // namespace leastcost
