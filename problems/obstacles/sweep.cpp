// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/sweep.hpp"

#include <algorithm>

namespace leastcost {

bool sweeps_clear(const Walls& walls, const Move& from, const Move& to) {
  constexpr int kMostAdvances = 50;
  constexpr double kShare = 0.9;   // of the room that there is: the rest is for rounding
  constexpr double kStuck = 1e-3;  // of the way: with so little room it comes too near
  const Eigen::VectorXd da = to.a - from.a, db = to.b - from.b;
  const double way = std::max(da.norm(), db.norm());
  double t = 0;
  for (int k = 0; k < kMostAdvances; ++k) {
    const double left = (1 - t) * way;
    if (!(left > 0)) return true;
    const double room = walls.room(from.a + t * da, from.b + t * db, 2 * left);
    if (k == 0 && !(room > 0)) return true;
    if (kShare * room >= left) return true;
    if (room < kStuck * way) return false;
    t += kShare * room / way;
  }
  return false;
}

}  // namespace leastcost
