// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/check/faults.hpp>

#include <sstream>
#include <string>
#include <utility>

namespace leastcost {

std::string text(const std::vector<Fault>& faults) {
  std::ostringstream out;
  for (const Fault& fault : faults)
    out << fault.name << ": " << fault.message << " (" << fault.measured << ", allowed " << fault.allowed << ")\n";
  return out.str();
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
