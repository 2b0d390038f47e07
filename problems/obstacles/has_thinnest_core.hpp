// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost {

/// Ability of walls that are made of cores with a distance to be kept from each: a robot's parts among obstacles.
class HasThinnestCore {
 public:
  virtual ~HasThinnestCore() = default;
  /// The least distance that is required from any core, in length units of the places; infinity where there is none.
  virtual double thinnest() const = 0;
};

}  // namespace leastcost
