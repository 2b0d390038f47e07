// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Orthonormal tangent frames at the free points, with the directions that are not free to move turned to the end of
/// each frame: outward at an active bound, along the path at the pinned point of a ring. All frames keep the same
/// width, so the chain system keeps its block size; a blocked coordinate has gradient 0 and a decoupled row in the
/// Hessian.
struct Frames {
  bool identity = false;     ///< flat domain or chart, nothing blocked: every basis is the identity
  Points bases;              ///< coordinate x (tangent * n)
  Points lifted;             ///< of a chart: the same in ambient coordinates, J T; ambient x (tangent * n)
  std::vector<int> blocked;  ///< per free point, how many trailing directions are blocked
};

}  // namespace leastcost
