// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace leastcost {

/// The bytes of a GeoPackage in WGS84 with a layer of each of these, in this order: pairs of its name and a GeoJSON
/// text. Empty where this GDAL has no GeoPackage (it was built without SQLite), or none is installed. Throws InputError
/// where a text is none.
std::string gdal_geopackage(const std::vector<std::pair<std::string, std::string>>& layers);

}  // namespace leastcost
