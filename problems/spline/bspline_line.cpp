// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/spline/bspline_line.hpp"

#include <Eigen/Core>
#include <vector>

namespace leastcost {

void to_bspline_coefficients(double* first, int n, std::size_t stride, std::size_t width) {
  using Row = Eigen::Map<Eigen::ArrayXd>;
  const auto row = [&](int i) {
    return Row(first + static_cast<std::ptrdiff_t>(stride) * i, static_cast<Eigen::Index>(width));
  };
  Row before = row(-1), after = row(n);
  before = (-11 * row(0) + 18 * row(1) - 9 * row(2) + 2 * row(3)) / 3;  // twice the slope
  after = (11 * row(n - 1) - 18 * row(n - 2) + 9 * row(n - 3) - 2 * row(n - 4)) / 3;
  std::vector<double> above(static_cast<std::size_t>(n), 0.0);  // of the eliminated matrix
  row(0) = (6 * row(0) + before) / 4;
  above[0] = 0.5;
  for (int i = 1; i < n; ++i) {
    const double below = i == n - 1 ? 2 : 1, pivot = 1 / (4 - below * above[static_cast<std::size_t>(i) - 1]);
    above[static_cast<std::size_t>(i)] = pivot;
    if (i == n - 1) row(i) -= after / 6;
    row(i) = (6 * row(i) - below * row(i - 1)) * pivot;
  }
  for (int i = n - 2; i >= 0; --i) row(i) -= above[static_cast<std::size_t>(i)] * row(i + 1);
  before = row(1) - before;
  after = row(n - 2) + after;
}

}  // namespace leastcost
