// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/faults.hpp>

#include <sstream>
#include <string>
#include <utility>

#include <leastcost/framework/errors.hpp>
#include "framework/fault_list.hpp"

namespace leastcost {

std::string text(const std::vector<Fault>& faults) {
  std::ostringstream out;
  for (const Fault& fault : faults)
    out << fault.name << ": " << fault.message << " (" << fault.measured << ", allowed " << fault.allowed << ")\n";
  return out.str();
}

void check_dimension(const Eigen::VectorXd& point, Eigen::Index dimension) {
  if (point.size() != dimension)
    throw InputError("a point to check with has " + std::to_string(point.size()) + " coordinates, not " +
                     std::to_string(dimension));
}

PointSampler of_dimension(const PointSampler& sampler, Eigen::Index dimension) {
  if (!sampler) throw InputError("there is no sampler of points to check with");
  return [&sampler, dimension](std::mt19937_64& engine) {
    Eigen::VectorXd x = sampler(engine);
    check_dimension(x, dimension);
    return x;
  };
}

PointSampler sample_box(Eigen::VectorXd lower, Eigen::VectorXd upper) {
  return [lower = std::move(lower), upper = std::move(upper)](std::mt19937_64& engine) {
    Eigen::VectorXd x(lower.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = std::uniform_real_distribution<double>(lower[i], upper[i])(engine);
    return x;
  };
}

}  // namespace leastcost
