// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/raster_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace leastcost {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kOnSide = 1e-9;  // of a cell: what lies this near to a side lies on it
constexpr double kUlps = 4 * std::numeric_limits<double>::epsilon();  // of a coordinate: the same

/// Adds the shares of a move at which a coordinate, in cells, is a whole number.
void add_crossings(double from, double to, std::vector<double>& shares) {
  const double low = std::min(from, to), high = std::max(from, to);
  for (double side = std::ceil(low); side <= high; ++side)
    if (high > low) shares.push_back(std::clamp((side - from) / (to - from), 0.0, 1.0));
}

/// The value of the cell at (column, row), in cells; of the cheapest one on a side or corner.
double value_at(const RasterGrid& values, double column, double row, const Eigen::Vector2d& near) {
  double least = kInfinite;
  for (const double x : {column - near[0], column + near[0]})
    for (const double y : {row - near[1], row + near[1]}) {
      if (!(x >= 0 && y >= 0 && x < values.columns && y < values.rows)) continue;
      const double value = values.value(static_cast<int>(y), static_cast<int>(x));
      if (value < least) least = value;  // false for NaN
    }
  return least;
}

}  // namespace

double cost_over_cells(const RasterGrid& values, const Eigen::Ref<const Eigen::MatrixXd>& curve) {
  double sum = 0;
  std::vector<double> shares;
  const Eigen::Vector2d far = values.corner.cwiseAbs().cwiseQuotient(values.cell);
  const Eigen::Vector2d near = (kUlps * far).cwiseMax(kOnSide);
  for (Eigen::Index i = 0; i + 1 < curve.cols(); ++i) {
    const Eigen::Vector2d from = (curve.col(i).head<2>() - values.corner).cwiseQuotient(values.cell);
    const Eigen::Vector2d to = (curve.col(i + 1).head<2>() - values.corner).cwiseQuotient(values.cell);
    shares.assign({0.0, 1.0});
    for (const int axis : {0, 1}) add_crossings(from[axis], to[axis], shares);
    std::sort(shares.begin(), shares.end());
    double mean = 0;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
      if (!(shares[k + 1] > shares[k])) continue;
      const Eigen::Vector2d middle = from + 0.5 * (shares[k] + shares[k + 1]) * (to - from);
      mean += (shares[k + 1] - shares[k]) * value_at(values, middle[0], middle[1], near);
    }
    const double length = (curve.col(i + 1) - curve.col(i)).norm();
    if (length > 0) sum += length * mean;
  }
  return sum;
}

}  // namespace leastcost
