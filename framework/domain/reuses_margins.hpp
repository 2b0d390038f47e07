// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// What the points of a chain kept from obstacles, beyond the clearance.
struct KeptMargins {
  int walls = 0;                          ///< how many there were; 0: nothing is known
  std::map<int, double> widths;           ///< by number of the wall, length units
  std::vector<std::vector<int>> resting;  ///< for each free point the walls that it rested on
};

/// Ability of a domain that fits segments (FitsSegments): margins to which a chain was fitted are a start for the next
/// one, when obstacles have moved a little.
class ReusesMargins {
 public:
  virtual ~ReusesMargins() = default;
  /// Those that this domain is fitted to, and where a chain rests on them. gaps: of the last fit (SegmentFit); a margin
  /// may be anywhere within what a fit allows, and is taken to a quarter of that for the next chain.
  virtual KeptMargins kept_margins(const CoordinatePath& path, const std::map<int, double>& gaps) const = 0;
  /// As FitsSegments::unfitted(), but with such margins. Null where they are of other walls.
  virtual std::shared_ptr<const ConstraintManifold> unfitted_with(const KeptMargins& kept, const CoordinatePath& path,
                                                                  double agreement) const = 0;
  /// Takes points of that chain along with the walls that they rested on, as far as those have gone no farther than the
  /// longest move; on a domain that unfitted_with() returned. Throws Interrupted after the deadline.
  virtual void carry_along(const KeptMargins& kept, CoordinatePath& path, const Deadline& deadline) const = 0;
};

}  // namespace leastcost
