// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost {

/// "3 vertices".
struct DataCount {
  std::string one, many;  ///< the word for it
  long count = 0;
};

/// Ability of a domain: it was made from data, which has a size and about which a user should know this and that.
class MadeFromData {
 public:
  virtual ~MadeFromData() = default;
  /// Length units. Ends that were copied with few digits are forgiven a part of it.
  virtual double diameter() const = 0;
  /// What a user should know about how the domain was made.
  virtual std::vector<std::string> notes() const = 0;
  /// How large the data is, for people; may be empty.
  virtual std::vector<DataCount> counts() const = 0;
};

}  // namespace leastcost
