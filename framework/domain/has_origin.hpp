// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost {

/// Ability of a domain of poses: its first ambient coordinates are the place of the origin of a body, in the plane or
/// in space (of a terrain: the place on the map). A move takes that place along a straight line. Obstacles of the plane
/// or of space keep it out.
class HasOrigin {
 public:
  virtual ~HasOrigin() = default;
  /// How many coordinates the place has: 2 or 3.
  virtual int origin_size() const = 0;
};

}  // namespace leastcost
