// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <leastcost/problems/cloud/point_samples.hpp>

namespace leastcost {

/// Reads a point cloud in double precision:
/// * PLY (ascii, binary little and big endian): x, y, z and, where present, nx, ny, nz of 'vertex'; faces and anything
/// else are passed over;
/// * .xyz, .txt, .csv and .asc: a row "x y z" or "x y z nx ny nz" per point, all rows alike, numbers separated by
/// blanks, commas or
///   semicolons; '#' starts a comment.
/// Normals are brought to unit length; where some are zero, all are dropped with a note. Points that repeat an earlier
/// one exactly are removed with a note. Throws InputError("file:line: ...") (file:byte offset in binary files) on the
/// first thing that does not fit: no points, a short row, a number that does not parse or is not finite, an unknown
/// extension.
PointSamples read_point_cloud(const std::filesystem::path& file);

}  // namespace leastcost
