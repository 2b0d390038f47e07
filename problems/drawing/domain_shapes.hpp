// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// What domains draw themselves with.
#include <cstddef>
#include <string>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/level_set/constraint_function.hpp>
#include "problems/drawing/surroundings.hpp"

namespace leastcost {

/// Triangles, thinned where they are too many for a drawing except around the columns of `focus`, which is noted.
TriangleSoup data_surface(TriangleSoup all, const Points& focus, std::vector<std::string>& notes);

/// Scans stand upright along y, maps and formulas along z: data that is not flat in z is taken for a scan.
Eigen::Vector3d up_of_data(const std::vector<Eigen::Vector3d>& points);

/// The surface of a chart around the columns of `u` (coordinate x m): whole periods, from pole to pole, within its
/// bounds.
TriangleSoup chart_surface(const ConstraintManifold& manifold, const HasChart& chart, const Points& u);

/// The level set of a function of space: all of it where it is closed and not much larger than the path, else the part
/// around the path. `whole`: the box in which the function is known, where it ends; all of it is drawn.
TriangleSoup level_surface(const ConstraintManifold& manifold, const ConstraintFunction& function,
                           const Surroundings& path, const Surroundings* whole, std::vector<std::string>& notes);

/// The same for a function of the plane.
std::vector<Points> level_curves(const ConstraintManifold& manifold, const ConstraintFunction& function,
                                 const Surroundings& path);

}  // namespace leastcost
