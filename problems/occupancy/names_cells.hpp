// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

namespace leastcost {

/// Ability: a domain that is made of cells can say why a place is in none of them.
class NamesCells {
 public:
  virtual ~NamesCells() = default;
  /// In words that follow "the target": "lies in blocked cells of room.pgm"; empty for a place of the domain.
  virtual std::string why_not_free(const Eigen::VectorXd& x) const = 0;
};

}  // namespace leastcost
