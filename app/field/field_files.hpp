// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/problems/initializers/cost_field.hpp>

namespace leastcost::app {

enum class FieldFormat { csv, npy, asc };

/// By the ending of a file name; throws InputError that names those there are.
FieldFormat field_format(std::string_view file);

/// A field as the bytes of a file, all digits. CSV: the coordinates of each node and its cost, the lowest y first; nan
/// where no path leads. NPY: an array of doubles (NumPy format 1.0), rows x columns, the northernmost row first as in
/// files of rasters; NaN where no path leads. ASC: an ESRI ASCII grid whose cells have the nodes in their middles, with
/// -9999 where no path leads; throws InputError for steps that differ along x and y, which it cannot say.
/// `names`: of the two coordinates.
std::string field_text(const CostField& field, FieldFormat format, const std::array<std::string, 2>& names);

/// A way down a field, and what it costs.
struct FieldWay {
  std::vector<Eigen::Vector2d> points;  ///< coordinates, as it is walked
  double cost = 0;                      ///< under the cost of the problem
};

/// CSV: the number of the way, from 0, and the coordinates of each of its points.
std::string ways_csv(const std::vector<FieldWay>& ways, const std::array<std::string, 2>& names);

}  // namespace leastcost::app
