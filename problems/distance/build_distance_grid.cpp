// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/distance/build_distance_grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kLost = 0.25;      ///< cells from the surface of the grid at which a place counts as lost
constexpr double kMostLost = 0.05;  ///< part of the places
constexpr std::size_t kMostPlaces = 5000;
constexpr double kOffsetCells = 3;  ///< cells that an offset must have: nearer, the kink at the sheet itself is felt
constexpr double kLargest = 0.25;   ///< part of the longest side of the surface that a cell may be
constexpr int kMostRefinements = 8;

/// Centres of cells beside nodes that are next to the surface, evenly thinned.
std::vector<Vector3d> centres_near_surface(const GridShape& shape, const std::vector<double>& values) {
  std::vector<Vector3d> centres;
  const double near = std::sqrt(3.0) / 2 * shape.cell;
  for (int k = 0; k + 1 < shape.count[2]; ++k)
    for (int j = 0; j + 1 < shape.count[1]; ++j)
      for (int i = 0; i + 1 < shape.count[0]; ++i)
        if (std::abs(values[shape.index(i, j, k)]) <= near)
          centres.emplace_back(shape.node(i, j, k) + Vector3d::Constant(shape.cell / 2));
  const std::size_t stride = (centres.size() + kMostPlaces - 1) / kMostPlaces;
  if (stride > 1) {
    for (std::size_t i = 0; i * stride < centres.size(); ++i) centres[i] = centres[i * stride];
    centres.resize((centres.size() + stride - 1) / stride);
  }
  return centres;
}

/// Distances of places on the surface from the zeros of the grid, to first order.
struct Misses {
  double worst = 0, mean = 0;
  std::size_t places = 0, lost = 0;
  Vector3d worst_at = Vector3d::Zero();
};

Misses measure(const DistanceSource& source, const DistanceGrid& grid, const std::vector<Vector3d>& centres,
               double offset, const BuildProgress& progress) {
  Misses misses;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (i % 256 == 0) report(progress, static_cast<double>(i) / static_cast<double>(centres.size()), "accuracy");
    std::optional<Vector3d> foot = source.foot(centres[i]);
    if (!foot) continue;
    if (offset > 0) *foot += offset * (centres[i] - *foot).normalized();
    Vector3d gradient;
    const double value = grid.evaluate(*foot, gradient);
    if (!std::isfinite(value)) continue;  // an open surface that leaves the grid
    // Where the gradient nearly vanishes no zero is near, whatever the quotient says.
    const double miss = std::abs(value) / std::clamp(gradient.norm(), 1e-3, 1.0);
    if (miss > misses.worst) misses.worst = miss, misses.worst_at = *foot;
    misses.mean += miss;
    ++misses.places;
    if (miss > kLost * grid.shape().cell) ++misses.lost;
  }
  if (misses.places > 0) misses.mean /= static_cast<double>(misses.places);
  return misses;
}

void check(const DistanceGridSettings& s) {
  const auto good = [](const std::optional<double>& x) { return !x || (*x > 0 && std::isfinite(*x)); };
  if (!good(s.cell)) throw OptionError("cell", "must be positive and finite");
  if (!good(s.accuracy)) throw OptionError("accuracy", "must be positive and finite");
  if (s.offset != 0 && !good(s.offset)) throw OptionError("offset", "must be positive and finite");
  if (s.cell && s.accuracy) throw OptionError("accuracy", "give either cell or accuracy, not both");
  if (s.margin < 1) throw OptionError("margin", "must be at least 1 cell");
}

struct Sampled {
  DistanceGrid grid;
  Misses misses;
};

Sampled sample(const DistanceSource& source, const Eigen::AlignedBox3d& box, const DistanceGridSettings& s, double cell,
               const BuildProgress& progress) {
  const GridShape shape = grid_around(box, cell, s.margin, s.memory);
  std::vector<double> values = sample_distances(source, shape, s.offset, progress);
  const std::vector<Vector3d> centres = centres_near_surface(shape, values);
  report(progress, 0, "spline");
  DistanceGrid grid(shape, std::move(values));
  const Misses misses = measure(source, grid, centres, s.offset, progress);
  return {std::move(grid), misses};
}

/// Cells that shrink until the accuracy is reached.
Sampled sample_to_accuracy(const DistanceSource& source, const Eigen::AlignedBox3d& box, const DistanceGridSettings& s,
                           double accuracy, const BuildProgress& progress) {
  double cell = std::min(box.sizes().maxCoeff() / 32,
                         s.offset > 0 ? s.offset / kOffsetCells : std::numeric_limits<double>::infinity());
  double order = 2, last_cell = 0, last_miss = 0;
  for (int i = 0; i < kMostRefinements; ++i) {
    Sampled sampled = sample(source, box, s, cell, progress);
    const double miss = sampled.misses.worst;
    if (miss <= accuracy) return sampled;
    if (last_cell > 0 && miss < last_miss) order = std::log(last_miss / miss) / std::log(last_cell / cell);
    order = std::clamp(order, 1.0, 4.0);
    last_cell = cell;
    last_miss = miss;
    constexpr double kSafe = 0.9, kLeast = 0.75, kMost = 0.35;
    cell *= std::clamp(kSafe * std::pow(accuracy / miss, 1 / order), kMost, kLeast);
    try {
      grid_around(box, cell, s.margin, s.memory);
    } catch (const InputError& error) {
      throw InputError("the accuracy of " + short_number(accuracy) + " cannot be reached: a cell of " +
                       short_number(last_cell) + " gives " + short_number(miss) + " (worst at " +
                       point_text(sampled.misses.worst_at) + "), and " + error.what());
    }
  }
  throw InputError("the accuracy of " + short_number(accuracy) + " was not reached: a cell of " +
                   short_number(last_cell) + " gives " + short_number(last_miss));
}

}  // namespace

std::vector<double> sample_distances(const DistanceSource& source, const GridShape& shape, double offset,
                                     const BuildProgress& progress) {
  std::vector<double> values = source.sample(shape, offset + source.exact_cells() * shape.cell, progress);
  if (offset > 0)
    for (double& v : values) v -= offset;
  return values;
}

SampledDistance build_distance_grid(const DistanceSource& source, const DistanceGridSettings& settings,
                                    const BuildProgress& progress) {
  check(settings);
  Eigen::AlignedBox3d box = source.box();
  const double size = box.sizes().maxCoeff();
  if (settings.offset > 0) {
    box.min().array() -= settings.offset;
    box.max().array() += settings.offset;
  }
  constexpr double kCells = 64;
  const double cell = settings.cell         ? *settings.cell
                      : settings.offset > 0 ? std::min(size / kCells, settings.offset / kOffsetCells)
                                            : size / kCells;
  if (cell > kLargest * size)
    throw OptionError("cell", "a cell of " + short_number(cell) +
                                  " is more than a quarter of the length of the surface, " + short_number(size) +
                                  "; use a smaller one");
  if (settings.offset > 0 && settings.offset < kOffsetCells * cell * (1 - 1e-9))
    throw OptionError("offset", "must be at least 3 cells (" + short_number(kOffsetCells * cell) +
                                    "), because an unsigned distance has a kink at the surface");
  Sampled sampled = settings.accuracy ? sample_to_accuracy(source, box, settings, *settings.accuracy, progress)
                                      : sample(source, box, settings, cell, progress);
  const Misses& m = sampled.misses;
  const double used = sampled.grid.shape().cell;
  if (m.places == 0) throw InputError("the grid has no zero near the surface: " + text(sampled.grid.shape()));
  if (static_cast<double>(m.lost) > kMostLost * static_cast<double>(m.places))
    throw InputError("a cell of " + short_number(used) + " is too large for this surface: " + std::to_string(m.lost) +
                     " of " + std::to_string(m.places) +
                     " points on it are more than a quarter of a cell from the surface of the grid, the worst at " +
                     point_text(m.worst_at) +
                     " (sheets thinner than a cell, and parts inside others, merge or vanish): use a smaller cell");
  SampledDistance result{std::move(sampled.grid), settings.offset, m.worst, m.mean, source.notes()};
  result.notes.push_back("distance grid: " + text(result.grid.shape()) + "; its surface is within " +
                         short_number(m.worst) + " (mean " + short_number(m.mean) + ") of its source, measured at " +
                         std::to_string(m.places) + " points");
  if (m.lost > 0)
    result.notes.push_back(std::to_string(m.lost) +
                           " of these points are more than a quarter of a cell off, the worst at " +
                           point_text(m.worst_at) + ": the surface has details thinner than a cell there");
  return result;
}

}  // namespace leastcost
