// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/problem/place_rounding.hpp"

#include <limits>

namespace leastcost {

double place_rounding(const Problem& problem, const CoordinatePath& chain) {
  if (find_ability<HasChart>(*problem.manifold) == nullptr) return 0;
  const Points x = positions(*problem.manifold, chain);
  const Index moves = x.cols() - 1;
  if (moves < 1) return 0;
  const double mean = (x.rightCols(moves) - x.leftCols(moves)).colwise().norm().mean();
  return mean > 0 ? std::numeric_limits<double>::epsilon() * x.colwise().norm().maxCoeff() / mean : 0;
}

}  // namespace leastcost
