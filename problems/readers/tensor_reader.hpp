// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace leastcost {

/// Symmetric positive definite 3 x 3 tensors from a text file, one row each: xx xy xz yy yz zz, separated by blanks;
/// '#' starts a comment, rows without a number are skipped. Throws InputError("file:line: ...") for a row that is not
/// six finite numbers or a tensor that is not positive definite.
std::vector<Eigen::Matrix3d> read_tensors(const std::filesystem::path& file);

}  // namespace leastcost
