// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/walls_in.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include <leastcost/framework/domain/has_origin.hpp>
#include "problems/obstacles/mapped_walls.hpp"

namespace leastcost {

std::shared_ptr<const Walls> walls_in(const ConstraintManifold& domain, ObstacleWalls::Obstacles obstacles,
                                      double clearance) {
  const int ambient = domain.dimensions().ambient;
  const auto* body = find_ability<HasOrigin>(domain);
  if (body == nullptr) return std::make_shared<const ObstacleWalls>(ambient, std::move(obstacles), clearance);
  std::vector<Eigen::Index> origin(static_cast<std::size_t>(body->origin_size()));
  std::iota(origin.begin(), origin.end(), 0);
  return std::make_shared<const MappedWalls>(
      ambient, std::move(origin),
      std::make_shared<const ObstacleWalls>(body->origin_size(), std::move(obstacles), clearance));
}

}  // namespace leastcost
