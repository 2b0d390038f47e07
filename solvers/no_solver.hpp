// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

/// Leaves the first path as it is, for the post-processors and the certificate. Where one of them finds the shortest
/// path by itself (straighten on a mesh, taut among obstacles in the plane) nothing else is needed.
class NoSolver final : public Solver {
 public:
  std::string_view name() const override { return "none"; }
  bool moves_points() const override { return false; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
};

}  // namespace leastcost
