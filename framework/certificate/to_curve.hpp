// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// Turns a chain into the curve that is delivered for it: the post-processors of the run.
using ToCurve = std::function<PostProcessed(const CoordinatePath&)>;

}  // namespace leastcost
