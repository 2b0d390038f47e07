// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/drawing/draws_itself.hpp>

namespace leastcost {

/// Ability of an obstacle in space that is not convex: its surface as triangles, for drawing. Of any thickness around
/// it nothing is in them.
class DrawsSurface {
 public:
  virtual ~DrawsSurface() = default;
  virtual TriangleSoup surface() const = 0;
};

}  // namespace leastcost
