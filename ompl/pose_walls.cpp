// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/pose_walls.hpp>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "problems/obstacles/mapped_walls.hpp"

namespace leastcost {

std::shared_ptr<const Walls> make_pose_walls(const StateColumns& states, std::shared_ptr<const Walls> poses) {
  if (poses->dimension() != states.rows())
    throw InputError("the obstacles have " + std::to_string(poses->dimension()) +
                     " dimensions, but states of the space have " + std::to_string(states.rows()) + " rows");
  if (!states.has_quaternions()) return poses;
  std::vector<Index> rows(static_cast<std::size_t>(states.rows()));
  std::iota(rows.begin(), rows.end(), 0);
  for (const Index first : states.quaternions()) {  // the scalar is the last of four there, the first of a pose
    const auto q = rows.begin() + first;
    std::rotate(q, q + 3, q + 4);
  }
  return std::make_shared<MappedWalls>(states.rows(), std::move(rows), std::move(poses));
}

}  // namespace leastcost
