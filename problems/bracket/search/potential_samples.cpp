// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/search/potential_samples.hpp"

#include <cmath>
#include <limits>

namespace leastcost {

PotentialSamples samples_of(const BracketPotential& potential) {
  constexpr int kNodes = 121;  // along the longer side
  PotentialSamples out;
  out.box = potential.searched();
  if (out.box.isEmpty()) return out;
  const Eigen::Vector2d size = out.box.sizes();
  const double cell = size.maxCoeff() / (kNodes - 1);
  out.columns = static_cast<int>(std::ceil(size[0] / cell)) + 1;
  out.rows = static_cast<int>(std::ceil(size[1] / cell)) + 1;
  for (int j = 0; j < out.rows; ++j)
    for (int i = 0; i < out.columns; ++i) {
      const Eigen::Vector2d part(static_cast<double>(i) / (out.columns - 1), static_cast<double>(j) / (out.rows - 1));
      const Eigen::Vector2d x = out.box.min() + part.cwiseProduct(size);
      out.values.push_back(potential.is_checked(x) ? potential.value(x) : std::numeric_limits<double>::infinity());
    }
  return out;
}

}  // namespace leastcost
