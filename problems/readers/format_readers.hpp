// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

// One reader per format. `content` is the whole file, `file` its name for messages; each throws InputError and
// Interrupted as read_mesh() describes. Every vertex number in the result is in range. The result may have no polygon.
PolygonSoup read_obj(std::string_view content, const std::string& file, const Deadline& deadline = {});
PolygonSoup read_off(std::string_view content, const std::string& file, const Deadline& deadline = {});
PolygonSoup read_ply(std::string_view content, const std::string& file, const Deadline& deadline = {});
PolygonSoup read_stl(std::string_view content, const std::string& file, const Deadline& deadline = {});

/// Whether the size is the one that a binary STL file with this triangle count has: the only way to tell it from text,
/// since some programs begin the binary header with "solid", too.
bool is_binary_stl(std::string_view content);

/// Vertices and corners are numbered in 32 bits.
inline constexpr std::size_t kMaxElements = std::numeric_limits<std::int32_t>::max();

}  // namespace leastcost
