// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/family/same_path.hpp>

#include <algorithm>
#include <cmath>

#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {
namespace {

/// Largest squared distance of a column of `a` from the nearest column of `b`.
double farthest2(const Points& a, const Points& b) {
  double worst = 0;
  for (const auto x : a.colwise()) worst = std::max(worst, (b.colwise() - x).colwise().squaredNorm().minCoeff());
  return worst;
}

}  // namespace

bool same_path(const Problem& problem, const CoordinatePath& a, const CoordinatePath& b) {
  constexpr double kSameCost = 1e-3;
  PathEnergy energy(problem, 1);
  const double cost = energy.cost(a);
  if (!(std::abs(energy.cost(b) - cost) <= kSameCost * cost)) return false;
  const Points x = positions(*problem.manifold, a), y = positions(*problem.manifold, b);
  const Index m = x.cols() - 1;
  if (m < 1 || y.cols() < 2) return false;
  const double segment2 = (x.rightCols(m) - x.leftCols(m)).colwise().squaredNorm().maxCoeff();
  return std::max(farthest2(x, y), farthest2(y, x)) <= 0.75 * 0.75 * segment2;
}

}  // namespace leastcost
