// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// The names of the coordinates of R^n: x, y, z up to three, else x0 .. x{n-1}.
std::vector<std::string> coordinate_names(int dimension);
/// x0 .. x{n-1}.
std::vector<std::string> numbered_names(const std::string& name, int count);
/// The names of the coordinates in which points of a domain are given: those of its chart, elsewhere of its space.
std::vector<std::string> point_coordinates(const ConstraintManifold& manifold);
/// The names of the coordinates of the space that a domain lies in.
std::vector<std::string> space_coordinates(const ConstraintManifold& manifold);

}  // namespace leastcost
