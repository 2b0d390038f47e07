// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/certificate/to_curve.hpp>
#include "framework/search/search.hpp"

namespace leastcost {

/// Makes of the solved chain the curve that is delivered for it, by the post-processors of the options.
void make_curve(const Search& search, Outcome& out);

/// The same for any chain of the problem, as the certificate asks for it. `search` and `out` must outlive it.
ToCurve curve_maker(const Search& search, const Outcome& out);

}  // namespace leastcost
