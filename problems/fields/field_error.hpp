// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace leastcost {

inline constexpr double kFirstOrder = 4;  ///< times the difference of two fields is the error, measured
/// The same without obstacles for costs that are the same in all directions, also over a raster.
inline constexpr double kOfDensities = 3;

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

/// The fields of several places, and the two sides of one that goes round a closed domain, meet in a kink, which may
/// lie between the nodes of both lattices. Raises the error to a quarter of the largest second difference of the
/// values. Nodes within two steps of a place, around which each field is a cone, do not count.
template <std::size_t D, class Field>
void allow_for_meeting_fronts(Field& field, bool closes_on_itself = false) {
  constexpr double kPart = 0.25, kNear = 2.5;
  if (field.places.size() < 2 && !closes_on_itself) return;
  std::array<std::ptrdiff_t, D> stride, node{};
  std::ptrdiff_t size = 1;
  for (std::size_t d = 0; d < D; ++d) {
    stride[d] = size;
    size *= field.count[d];
  }
  const auto is_near_place = [&] {
    return std::any_of(field.places.begin(), field.places.end(), [&](const auto& place) {
      double far = 0;
      for (std::size_t d = 0; d < D; ++d) {
        const auto k = static_cast<std::ptrdiff_t>(d);
        const double steps = (place[k] - field.lower[k]) / field.step[k] - static_cast<double>(node[d]);
        far = std::max(far, std::abs(steps));
      }
      return far < kNear;
    });
  };
  double most = 0;
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    std::ptrdiff_t rest = i;
    for (std::size_t d = 0; d < D; ++d) {
      node[d] = rest % field.count[d];
      rest /= field.count[d];
    }
    const auto value = [&](std::ptrdiff_t at) { return field.values[static_cast<std::size_t>(at)]; };
    for (std::size_t d = 0; d < D; ++d) {
      if (node[d] == 0 || node[d] + 1 == field.count[d]) continue;
      const double bend = std::abs(value(i - stride[d]) - 2 * value(i) + value(i + stride[d]));
      if (bend > most && std::isfinite(bend) && !is_near_place()) most = bend;
    }
  }
  field.error = std::max(field.error, kPart * most);
}

/// Counts the nodes at which a unit of length costs nothing, and keeps the first. `place`: of a node by its number.
template <class Field, class Place>
void count_free_nodes(const std::vector<double>& densities, const Place& place, Field& field) {
  for (std::size_t k = 0; k < densities.size(); ++k)
    if (densities[k] == 0 && field.free_nodes++ == 0) field.free_at = place(k);
}

/// Whether no node farther than a few steps from the places is reached, though there are some; or none farther than one
/// step, where a lattice is too small for that.
template <std::size_t D, class Field>
bool is_enclosed(const Field& field) {
  constexpr double kNear = 5, kBeside = 1;  // steps; paths leave a place straight for the nodes within 3.5
  bool some_far = false, some_beside = false, left = false;
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    std::size_t rest = i;
    double nearest = std::numeric_limits<double>::infinity();
    std::array<double, D> node{};
    for (std::size_t d = 0; d < D; ++d) {
      node[d] = static_cast<double>(rest % static_cast<std::size_t>(field.count[d]));
      rest /= static_cast<std::size_t>(field.count[d]);
    }
    for (const auto& place : field.places) {
      double far = 0;
      for (std::size_t d = 0; d < D; ++d) {
        const auto k = static_cast<std::ptrdiff_t>(d);
        far = std::max(far, std::abs((place[k] - field.lower[k]) / field.step[k] - node[d]));
      }
      nearest = std::min(nearest, far);
    }
    if (nearest <= kBeside) continue;
    const bool reached = std::isfinite(field.values[i]);
    if (reached && nearest > kNear) return false;
    some_beside = true;
    left = left || reached;
    some_far = some_far || nearest > kNear;
  }
  return some_far || (some_beside && !left);
}

/// The sum of two fields over the same nodes less its least value, with the errors of both. `known`: what the cheapest
/// way of all costs at most. It leads through no node: what the least value exceeds it by is an error too; more than
/// the errors of the fields is taken off. False: no node has a way to both.
template <class Field>
bool add_field(const Field& to, double known, Field& sum) {
  double least = std::numeric_limits<double>::infinity();
  sum.places.insert(sum.places.end(), to.places.begin(), to.places.end());
  for (std::size_t k = 0; k < sum.values.size(); ++k) {
    sum.values[k] += to.values[k];
    if (sum.values[k] < least) least = sum.values[k];
  }
  if (!(least < std::numeric_limits<double>::infinity())) return false;
  sum.error += to.error;
  sum.mean_error += to.mean_error;
  const double beside = std::max(0.0, least - known);
  if (beside > sum.error) {
    least = known;
  } else {
    sum.error += beside;
    sum.mean_error += beside;
  }
  for (double& value : sum.values) value -= least;
  sum.unresolved = std::max(sum.unresolved, to.unresolved);
  return true;
}

}  // namespace leastcost
