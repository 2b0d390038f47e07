// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/raster/raster_options.hpp>

#include "catalogue/plugins/attached_options.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

/// Solvers of third-party libraries, each registered by the CMakeLists.txt of its folder in solvers/. Those whose
/// library was not found are there too, and say how to get it. Its definition is written by CMake.
std::vector<SolverPlugin> back_ends();

/// The same for first paths: OMPL's planners (ompl/CMakeLists.txt).
std::vector<InitializerPlugin> planners();

/// The same for robots: those of URDF files (urdf/CMakeLists.txt).
std::vector<RobotPlugin> robots_of_libraries();

/// The same for obstacles: those of OctoMap files (octomap/CMakeLists.txt).
std::vector<ObstaclePlugin> obstacles_of_libraries();

/// Reads a raster file; throws InputError.
using RasterReader = RasterFile (*)(const std::filesystem::path& file);
/// GDAL (gdal/CMakeLists.txt); null in builds without it.
RasterReader raster_reader_of_libraries();

/// The CRS of a text: WKT, as .prj files have it; null where it is none that is known.
using CrsReader = std::shared_ptr<const RasterCrs> (*)(const std::string& text);
CrsReader crs_reader_of_libraries();

/// The bytes of a GeoPackage from the names and the GeoJSON texts of its layers.
using GeoPackageWriter = std::string (*)(const std::vector<std::pair<std::string, std::string>>& layers);
GeoPackageWriter geopackage_writer_of_libraries();

/// The bytes of a GeoTIFF of a raster. `what`, `unit`: of its values.
using GeoTiffWriter = std::string (*)(const RasterGrid& raster, const std::string& what, const std::string& unit);
GeoTiffWriter geotiff_writer_of_libraries();

/// What this build has. `library`: with its version.
template <class P>
P present(P entry, const std::string& library) {
  entry.library = library;
  return entry;
}

/// What this build has not. `package`: that of Debian.
template <class P = SolverPlugin>
P absent(const char* type, const char* summary, const char* package) {
  P entry;
  entry.type = type;
  entry.summary = summary;
  entry.missing = std::string("install ") + package + " (Debian) and rebuild";
  entry.defaults = [] { return std::make_unique<OptionsOf<NoOptions>>(); };
  return entry;
}

}  // namespace leastcost
