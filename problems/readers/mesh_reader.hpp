// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// Reads OBJ, OFF, PLY (ascii, binary little and big endian) or STL (ascii and binary), told apart by the extension and
/// checked against the content, strictly and in double precision. STL vertices with bitwise equal positions are merged
/// (the format has no sharing). Throws InputError("file:line: ...") (file:byte offset in binary files) on the first
/// thing that does not fit: a missing file, a short record, a number that does not parse or is not finite, an index out
/// of range, an element count that the file does not hold (before memory is taken for it), an unknown extension. Throws
/// Interrupted in the midst of a text.
PolygonSoup read_mesh(const std::filesystem::path& file, const Deadline& deadline = {});

}  // namespace leastcost
