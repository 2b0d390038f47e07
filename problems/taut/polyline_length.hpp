// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Of a polyline, d x m with m >= 1.
inline double polyline_length(const Points& polyline) {
  return (polyline.rightCols(polyline.cols() - 1) - polyline.leftCols(polyline.cols() - 1)).colwise().norm().sum();
}

}  // namespace leastcost
