// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>

namespace leastcost {

/// Velocities at places from a text file, one row each: x, y, u, v for dimension 2, x, y, z, u, v, w for 3. A first row
/// of words names the columns, in any order and among others; without it they are the first ones. Commas or semicolons
/// separate columns, or else blanks; '#' starts a comment; rows without a word are skipped. A velocity that is `nan`,
/// or empty between two commas, is missing: NaN. Rows x 2 dimension. Throws InputError("file:line: ...").
Eigen::MatrixXd read_flow(const std::filesystem::path& file, int dimension);

}  // namespace leastcost
