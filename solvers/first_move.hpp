// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Part of a segment by which a method may move a point before it knows any scale.
inline constexpr double kFirstMove = 0.1;

/// Mean length of a segment in coordinates; one of a ring of one point, which has no scale.
inline double mean_segment(const CoordinatePath& path) {
  const Index n = path.u.cols() - 1;
  if (n == 0) return 1;
  return (path.u.rightCols(n) - path.u.leftCols(n)).colwise().norm().mean();
}

}  // namespace leastcost
