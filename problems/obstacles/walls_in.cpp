// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/walls_in.hpp"

#include <utility>

#include <leastcost/framework/domain/has_origin.hpp>
#include "problems/obstacles/origin_walls.hpp"

namespace leastcost {

std::shared_ptr<const Walls> walls_in(const ConstraintManifold& domain, ObstacleWalls::Obstacles obstacles,
                                      double clearance) {
  const int ambient = domain.dimensions().ambient;
  const auto* body = find_ability<HasOrigin>(domain);
  if (body == nullptr) return std::make_shared<const ObstacleWalls>(ambient, std::move(obstacles), clearance);
  return std::make_shared<const OriginWalls>(
      ambient, std::make_shared<const ObstacleWalls>(body->origin_size(), std::move(obstacles), clearance));
}

}  // namespace leastcost
