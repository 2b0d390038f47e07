// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace leastcost {

/// Points from a text file, one coordinate per name, names x m: one row per point, numbers separated by commas,
/// semicolons or blanks;
/// '#' starts a comment. A first row that is not numeric is a header; where it has columns of these names those are
/// taken, so the path.csv of an earlier run works, otherwise the first columns. Throws InputError("file:line: ...").
Eigen::MatrixXd read_waypoints(const std::filesystem::path& file, const std::vector<std::string>& names);

}  // namespace leastcost
