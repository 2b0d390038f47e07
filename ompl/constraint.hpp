// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/ompl/forward.hpp>

namespace leastcost {

/// A domain in its ambient space as a constraint on which OMPL plans (ProjectedStateSpace and the others). Its function
/// is what leads from the nearest point of the domain to a place, in the directions normal to it there: its length is
/// the distance, its Jacobian the normals. Where a place has no nearest point, the function is infinite.
///
/// `tolerance`: how far from the domain a state counts as on it, length units; projections are as exact as the domain's
/// own. Throws InputError for a domain given by a chart (plan in its coordinates), one that fills its space, and a
/// tolerance that is no positive number.
std::shared_ptr<ompl::base::Constraint> make_constraint(std::shared_ptr<const ConstraintManifold> domain,
                                                        double tolerance = 1e-7);

}  // namespace leastcost
