// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/catalogue/run/run_parts.hpp>
#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// Where a path began with the straight line, under a cost that may make another way cheaper: what a few bows beside it
/// lead to, solved with few points and no certificate. A note on the cheapest one with the line of a configuration that
/// takes it, where it costs less by a hundredth; "" where there is none.
std::string look_elsewhere(const RunParts& parts, const Result& result, const Monitor& monitor);

}  // namespace leastcost
