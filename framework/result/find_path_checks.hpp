// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// What comes into find_path() and what its parts return. All throw InputError.
void check(const FindOptions& options);

/// Two names of one point between which the straight line has no length, two longitudes of a pole say: there is nothing
/// to minimise; and ends whose distance is beyond the lengths of sound_size.hpp. (A target that is the source after a
/// turn around a seam states a loop; see cheaper_image().)
void refuse_one_point(const Problem& problem);

/// Ends within an obstacle or its clearance.
void refuse_end_in_clearance(const Problem& problem);

/// A path that is none of this problem, by its shape or its numbers; `what` is its name.
void check_path(const Problem& problem, const CoordinatePath& path, Index least, const std::string& what);

/// What is no curve with the points of `before` on it.
void check_processed(const Problem& problem, const CoordinatePath& before, const PostProcessed& after);

}  // namespace leastcost
