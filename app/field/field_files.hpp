// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/field/run_field.hpp"

namespace leastcost::app {

enum class FieldFormat { csv, npy, asc, tif, vti, vtp, ply };

/// By the ending of a file name, in capitals too; throws InputError that names those there are.
FieldFormat field_format(std::string_view file);

/// Throws InputError for a format that a field over such nodes does not have, and for GeoTIFF in a build without GDAL.
void check_format(FieldFormat format, FieldNodes nodes);

/// A field as the bytes of a file, all digits.
///
/// Over a lattice. CSV: the coordinates of each node and its cost, the lowest y first; nan where no path leads. NPY: an
/// array of doubles (NumPy format 1.0), rows x columns, the northernmost row first as in files of rasters; NaN where no
/// path leads. ASC: an ESRI ASCII grid whose cells have the nodes in their middles, with -9999 where no path leads;
/// throws InputError for steps that differ along x and y, which it cannot say. TIF: a GeoTIFF of doubles, likewise,
/// with NaN where no path leads, in the CRS of the raster that the configuration reads; one that was read in degrees is
/// in degrees.
///
/// In space. CSV: x, y, z and cost, x fastest. NPY: one array (nodes along x, y, z), so that [i, j, k] is node (i, j,
/// k). VTI: an image of VTK with the costs as point data; -1 where no path leads.
///
/// On a mesh. CSV: the number of each vertex in the file, x, y, z and the cost. NPY: one double per vertex of the file;
/// NaN where no path leads and for vertices of no face. VTP and PLY: the mesh with cost and error as point data; -1
/// where no path leads.
///
/// Throws InputError as check_format().
std::string field_text(const RunField& field, FieldFormat format);

/// CSV: the number of the way, from 0, and the coordinates of each of its points.
std::string ways_csv(const RunField& field, const std::vector<FieldWay>& ways);

/// Whether the first coordinate of places on the Earth is the latitude.
bool latitude_first(const Problem& problem);
/// A field in two coordinates with east along its first one and north along its second, as maps have them.
CostField as_map(const RunField& field);

}  // namespace leastcost::app
