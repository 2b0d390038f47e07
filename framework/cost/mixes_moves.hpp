// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// The two legs of which a move v is made: share v + across, and (1 - share) v - across.
struct MixedMove {
  double share = 0;        ///< between 0 and 1
  Eigen::VectorXd across;  ///< ambient, in the tangent space
};

/// Ability: the cost is a convex hull, and a move on one of its flat parts costs what its legs cost together under the
/// law whose hull it is: who moves by that law goes there in a zigzag, however narrow.
class MixesMoves {
 public:
  static constexpr std::string_view kAbility = "hull of a law";
  virtual ~MixesMoves() = default;
  /// Of the move v (ambient) on a domain with tangent space spanned by the columns of `tangents` (ambient x k). Nothing
  /// where the law makes the move as it is.
  virtual std::optional<MixedMove> legs(const Points& tangents, const Eigen::VectorXd& v) const = 0;
};

}  // namespace leastcost
