// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace leastcost {

inline constexpr double kFirstOrder = 4;  ///< times the difference of two fields is the error, measured
/// The same over a raster of costs without obstacles, whose costs have kinks between the values.
inline constexpr double kOfRasters = 2;

/// Sets error, mean_error and unresolved of a field from its values at the nodes that a field on half as many cells has
/// too; `factor` times their differences. Without common nodes the errors stay as they are.
template <class Field>
void estimate_error(const std::vector<double>& fine, const std::vector<double>& coarse, double factor, Field& field) {
  double sum = 0, largest = 0;
  std::size_t common = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    if (std::isfinite(fine[k]) && !std::isfinite(coarse[k])) ++field.unresolved;
    if (!std::isfinite(fine[k]) || !std::isfinite(coarse[k])) continue;
    const double apart = std::abs(fine[k] - coarse[k]);
    largest = std::max(largest, apart);
    sum += apart;
    ++common;
  }
  if (common == 0) return;
  field.error = factor * largest;
  field.mean_error = factor * sum / static_cast<double>(common);
}

/// The sum of two fields over the same nodes less its least value, with the errors of both. False: no node has a way to
/// both.
template <class Field>
bool add_field(const Field& to, Field& sum) {
  double least = std::numeric_limits<double>::infinity();
  sum.places.insert(sum.places.end(), to.places.begin(), to.places.end());
  for (std::size_t k = 0; k < sum.values.size(); ++k) {
    sum.values[k] += to.values[k];
    if (sum.values[k] < least) least = sum.values[k];
  }
  if (!(least < std::numeric_limits<double>::infinity())) return false;
  for (double& value : sum.values) value -= least;
  sum.error += to.error;
  sum.mean_error += to.mean_error;
  sum.unresolved = std::max(sum.unresolved, to.unresolved);
  return true;
}

}  // namespace leastcost
