// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

struct TightChainOptions {
  double gain = 3e-4;  ///< of the length: a pull and a refinement that bring less are the last
  double kept = 1e-7;  ///< of the length: from walls, for rounding and for what asks at other places than they do
};

/// Pulls a polyline tight among walls of any shape in a flat domain of any dimension, as PulledChain does: coarse
/// first, then with more vertices where it bends. `start`: d x m, clear. `metric`: of the length, d x d. `is_clear` has
/// the last word: what it refuses is not returned. Never longer than the start, which comes back where nothing better
/// was found. After the deadline: as far as it came.
Points tight_chain(const ConstraintManifold& domain, const Walls& walls, const Eigen::MatrixXd& metric,
                   const Points& start, const std::function<bool(const Points&)>& is_clear,
                   const TightChainOptions& options, const Monitor& monitor);

}  // namespace leastcost
