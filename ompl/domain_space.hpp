// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/domain/has_sample_box.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/ompl/forward.hpp>
#include "problems/initializers/clear_lines.hpp"

namespace leastcost {

/// The smooth domain of a problem as a space in which OMPL plans, set up: states are its coordinates within `box`,
/// samples and what is between two states lie on it, and what is free the lines say. Both outlive it. One thread at a
/// time.
std::shared_ptr<ompl::base::SpaceInformation> make_domain_space(const Problem& problem, const SampleBox& box,
                                                                ClearLines& lines);

}  // namespace leastcost
