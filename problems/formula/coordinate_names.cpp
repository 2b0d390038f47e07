// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/formula/coordinate_names.hpp"

#include <algorithm>

#include <leastcost/framework/domain/names_coordinates.hpp>

namespace leastcost {

std::vector<std::string> numbered_names(const std::string& name, int count) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(std::max(0, count)));
  for (int i = 0; i < count; ++i) names.push_back(name + std::to_string(i));
  return names;
}

std::vector<std::string> coordinate_names(int dimension) {
  std::vector<std::string> names = {"x", "y", "z"};
  if (dimension > 3) return numbered_names("x", dimension);
  names.resize(static_cast<std::size_t>(std::max(0, dimension)));
  return names;
}

std::vector<std::string> point_coordinates(const ConstraintManifold& manifold) {
  if (const auto* chart = find_ability<HasChart>(manifold)) return chart->coordinate_names();
  return space_coordinates(manifold);
}

std::vector<std::string> space_coordinates(const ConstraintManifold& manifold) {
  if (const auto* domain = find_ability<NamesCoordinates>(manifold)) return domain->coordinate_names();
  return coordinate_names(manifold.dimensions().ambient);
}

}  // namespace leastcost
