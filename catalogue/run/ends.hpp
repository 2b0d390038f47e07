// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/catalogue/run/run_parts.hpp>
#include <leastcost/problems/robots/robot.hpp>
#include "catalogue/config/run_config.hpp"
#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost {

/// The end with a point in the place of the name of a state. `robot` may be null. Throws OptionError where it has no
/// such state.
EndOptions with_state(EndOptions options, const Robot* robot, const std::string& path);

/// The end with a point in the place of its longitude and latitude, which the domain or the cost (may be null) knows.
/// Throws OptionError where neither does.
EndOptions in_coordinates(EndOptions options, const ConstraintManifold& manifold, const SegmentCost* cost,
                          const std::string& path);

/// Puts an end of the configuration onto the manifold. `path` ("ends.source") is for messages. Throws OptionError where
/// the domain has no such vertex or face, or the point is farther away than its tolerance.
PlacedEnd place_end(const ConstraintManifold& manifold, const EndOptions& options, const std::string& path);

/// The same for the target of parts whose source is placed, and in the domain without its obstacles. It may be the
/// place of the source.
void place_target(const EndOptions& options, const std::string& path, RunParts& out);

/// Adds a note of an end that was given farther than 1 % of its diameter from a domain that is made from data.
void note_far_end(const std::string& which, const PlacedEnd& placed, RunParts& out);

/// Throws OptionError(key) for a robot's target that is more than 100 turns of a joint without limits from the source:
/// each turn would be checked.
void refuse_many_turns(const RunParts& parts, const PathEnd& target, const std::string& key);

/// Throws OptionError with this key for a target that is the place of the source.
void refuse_one_place(const Problem& problem, const std::string& key);

/// Whether both ends are one place, perhaps by coordinates that state no winding: nothing lies between them.
bool are_one_place(const Problem& problem);
/// Whether they are not, and only the rounding of their coordinates tells them apart.
bool are_one_place_but_for_rounding(const Problem& problem);

/// Throws OptionError with this key for an end that an obstacle does not let be there.
void refuse_end_in_clearance(const Problem& problem, const PathEnd& end, const std::string& key);

/// Where the source is in space.
Eigen::VectorXd source_position(const Problem& problem);

}  // namespace leastcost
