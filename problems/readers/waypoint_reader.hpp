// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>

namespace leastcost {

/// Points from a text file, dim x m: one row per point, numbers separated by commas, semicolons or blanks; '#' starts a comment. A first
/// row that is not numeric is a header; where it names columns x, y, z (or x0, x1, ...) those are taken, so the path.csv
/// of an earlier run works, otherwise the first `dim` columns. Throws InputError("file:line: ...").
Eigen::MatrixXd read_waypoints(const std::filesystem::path& file, int dim);

}  // namespace leastcost
