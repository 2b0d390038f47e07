// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost {

/// Ability of a domain without a chart: its coordinates have names of their own, where points are given by name, and
/// the columns of files. Elsewhere they are x, y, z, or x0, x1, ...
class NamesCoordinates {
 public:
  virtual ~NamesCoordinates() = default;
  /// One each, all different.
  virtual std::vector<std::string> coordinate_names() const = 0;
};

}  // namespace leastcost
