// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Ability of a domain: a part that moves and projections need is made when it is first asked for, and kept (the search
/// tree of a mesh, which a path along edges never asks for). A search with a deadline has it made beforehand, by a call
/// that looks at the clock; prepare() has it made without one.
class MakesOnDemand {
 public:
  virtual ~MakesOnDemand() = default;
  /// Throws Interrupted once the deadline has passed; nothing is kept then. Threads may ask at once.
  virtual void make(const Deadline& deadline) const = 0;
  /// Whether the projection of this path asks for that part.
  virtual bool is_asked_by(const CoordinatePath& path) const = 0;
};

}  // namespace leastcost
