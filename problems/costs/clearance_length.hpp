// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A soft clearance.
struct ClearanceLengthOptions {
  double weight = 1;  ///< of what is in contact, against length
  double reach = 0;   ///< gap from which on an obstacle does not matter, length units
  void fields(FieldVisitor& visit);
};

/// Length that counts more near obstacles: |b - a| (1 + weight sum_i (1 - g_i / reach)^3), over the obstacles whose gap
/// g_i (the distance beyond radius and clearance) at the middle of the segment is less than `reach`: twice
/// differentiable where the distances are, and so is what it is a sum of. Second derivatives of gaps are differences of
/// their slopes. A soft clearance keeps nothing out: the walls do that, or nothing. Throws OptionError.
std::shared_ptr<const SegmentCost> make_clearance_length(const ClearanceLengthOptions& options, int dim,
                                                         std::shared_ptr<const Walls> walls);

/// Among the obstacles of a domain; throws OptionError where it has none.
std::shared_ptr<const SegmentCost> make_clearance_length(const ClearanceLengthOptions& options, int dim,
                                                         const std::shared_ptr<const ConstraintManifold>& domain);

}  // namespace leastcost
