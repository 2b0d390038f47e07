// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace leastcost {

/// One array of a VTK XML file (ParaView). `type`: Float64, Int64, Int32; `values`: text, white space between numbers.
std::string vtp_array(std::string_view name, std::int64_t components, std::string_view type, const std::string& values);

struct VtpCounts {
  std::int64_t points = 0, lines = 0, polygons = 0;
};

/// The file around one piece: its PointData, Points, Lines and so on, made of arrays.
std::string vtp_file(const VtpCounts& counts, const std::string& piece);

}  // namespace leastcost
