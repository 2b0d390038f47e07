// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/check/fault_list.hpp"

#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/counted.hpp"

namespace leastcost {

void check_dimension(const Eigen::VectorXd& point, Eigen::Index dimension) {
  if (point.size() != dimension)
    throw InputError("a point to check with has " + counted(point.size(), "coordinate") + ", not " +
                     std::to_string(dimension));
}

PointSampler of_dimension(const PointSampler& sampler, Eigen::Index dimension) {
  if (!sampler) throw InputError("there is no sampler of points for the check");
  return [&sampler, dimension](std::mt19937_64& engine) {
    Eigen::VectorXd x = sampler(engine);
    check_dimension(x, dimension);
    return x;
  };
}

}  // namespace leastcost
