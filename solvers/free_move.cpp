// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/free_move.hpp"

#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include "framework/domain/in_parts.hpp"

namespace leastcost {
namespace {

constexpr double kSame = 1e-13;  ///< of the size of the coordinates

}  // namespace

bool move_freely(const ConstraintManifold& manifold, const CoordinatePath& from, const Points& step, CoordinatePath& to,
                 const Deadline& deadline) {
  retract(manifold, from, step, to, deadline);
  const Index first = from.free_begin(), n = from.free_count();
  const double size = from.u.cwiseAbs().maxCoeff() + step.cwiseAbs().maxCoeff();
  const auto is_at = [&](const Points& there) {
    return !((to.u.middleCols(first, n) - there).cwiseAbs().maxCoeff() > kSame * size);
  };
  if (manifold.shape() == Shape::flat || find_ability<HasChart>(manifold) != nullptr)
    return is_at(from.u.middleCols(first, n) + step);
  if (find_ability<GoesBeyondBounds>(manifold) != nullptr) {
    CoordinatePath unstopped;
    retract(manifold, from, step, unstopped, deadline, true);
    return is_at(unstopped.u.middleCols(first, n));
  }
  return true;
}

}  // namespace leastcost
