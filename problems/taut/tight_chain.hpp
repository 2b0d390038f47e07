// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/monitor.hpp>
#include <leastcost/framework/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

Points tight_chain(const ConstraintManifold& domain, const Walls& walls, const Eigen::MatrixXd& metric,
                   const Points& start, double excess, const std::function<bool(const Points&)>& is_clear,
                   const Monitor& monitor);

}  // namespace leastcost
