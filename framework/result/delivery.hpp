// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// What becomes of a solved chain: its curve by the post-processors, and the parts of a result that say so.

/// The chain as a curve, before any post-processing.
PostProcessed chain_as_curve(PathEnergy& energy, const CoordinatePath& path);

/// What the post-processors make of a chain. Each takes the curve that the one before it has made: `so_far` keeps it,
/// for the case that the next one throws.
void post_process(const Problem& problem, const FirstPath& first, const FindOptions& options, const Monitor& monitor,
                  PostProcessed& so_far);

/// The same, but a path that is solved stays, whatever becomes of its curve: `so_far` is what there was before the step
/// that threw, and the reason is returned. Throws Interrupted only.
std::optional<std::string> post_process_or_say_why(const Problem& problem, const FirstPath& first,
                                                   const FindOptions& options, const Monitor& monitor,
                                                   PostProcessed& so_far);

void deliver(const PostProcessed& processed, Eigen::VectorXd costs, Result& result);

/// A path about which nothing is measured.
void deliver_unmeasured(Result& result);

/// A ring that the solver lost may still be found again from the first path, by a post-processor that certifies itself.
bool has_collapsed(const Result& result, const PostProcessed& processed);

}  // namespace leastcost
