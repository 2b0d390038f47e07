// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost::app {

// The small files that starting configurations read until there are better ones.

std::string sample_mesh();     ///< OBJ: a hill over the unit square, 21 x 21 vertices
std::string sample_cloud();    ///< XYZ with normals: a torus
std::string sample_heights();  ///< ESRI grid: hills, 60 x 45 cells of 25 m
std::string sample_costs();    ///< CSV: a marsh, 24 rows of 32 costs
std::string sample_rooms();    ///< Moving AI map

}  // namespace leastcost::app
