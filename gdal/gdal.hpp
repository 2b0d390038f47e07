// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// All that is for rasters of GDAL, by component gdal; a library of its own, built where GDAL is found.

#include <leastcost/gdal/gdal_geopackage.hpp>
#include <leastcost/gdal/gdal_geotiff.hpp>
#include <leastcost/gdal/gdal_raster.hpp>
