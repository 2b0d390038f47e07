// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/vtp.hpp"

#include <fmt/format.h>

namespace leastcost {

std::string vtp_array(std::string_view name, std::int64_t components, std::string_view type,
                      const std::string& values) {
  return fmt::format(
      "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}        "
      "</DataArray>\n",
      type, name, components, values);
}

std::string vtp_file(const VtpCounts& counts, const std::string& piece) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n  "
      "<PolyData>\n    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n{}    </Piece>\n  </PolyData>\n</VTKFile>\n",
      counts.points, counts.lines, counts.polygons, piece);
}

}  // namespace leastcost
