// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost {

/// Ability of a cost: it has found out something about itself that belongs beside every result (find_path() puts it
/// into the notes): what was proved about a formula, or only sampled.
class HasNotes {
 public:
  virtual ~HasNotes() = default;
  virtual std::vector<std::string> notes() const = 0;  ///< sentences without a full stop
};

}  // namespace leastcost
