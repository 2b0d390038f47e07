// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost {

/// "3 vertices".
struct DataCount {
  std::string one, many;  ///< the word for it
  long count = 0;         ///< how many there are
};

/// Ability of a domain: it was made from data, which has a size and about which a user should know this and that.
class MadeFromData {
 public:
  virtual ~MadeFromData() = default;
  virtual double diameter() const = 0;  ///< length units
  /// How far off an end may be that was copied with few digits, length units.
  virtual double end_tolerance() const { return 0.01 * diameter(); }
  /// What a user should know about how the domain was made.
  virtual std::vector<std::string> notes() const = 0;
  /// How large the data is, for people; may be empty.
  virtual std::vector<DataCount> counts() const = 0;
};

}  // namespace leastcost
