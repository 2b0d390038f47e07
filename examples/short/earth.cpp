// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// London to Tokyo on the WGS84 ellipsoid, ends as (latitude, longitude) in degrees.
#include <cstdio>

#include <leastcost/leastcost.hpp>

int main() {
  using namespace leastcost;
  Problem problem;
  problem.manifold = std::make_shared<EarthManifold>();
  problem.cost = make_euclidean_cost(3);
  problem.source.u = Eigen::Vector2d(51.5, -0.1);
  problem.target.u = Eigen::Vector2d(35.7, 139.7);
  const Result path = find_path(problem);
  std::printf("%.3f km +- %.1g m\n", path.certificate.estimate.value / 1000, path.certificate.estimate.error);
  return path.certificate.certified() ? 0 : 1;
}
