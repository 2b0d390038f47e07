// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The march takes nodes of nearly equal cost together. Where n is much lower at some node than elsewhere it takes them
// one by one instead, in the order of their costs; the fields must be the same.
#include "problems/fields/isotropic_march.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

constexpr std::int32_t kSide = 120;
constexpr double kWall = std::numeric_limits<double>::infinity();

using Density = std::function<double(double, double)>;

std::vector<double> marched(const std::vector<double>& densities, const Density& density, const Vector2d& step) {
  const IsotropicMarch::Lattice lattice{Vector2d::Zero(), step, {kSide, kSide}};
  IsotropicMarch march(lattice, densities, {});
  const auto straight = [&](const Vector2d& a, const Vector2d& b) {
    constexpr int kParts = 16;
    double sum = 0;
    for (int k = 0; k < kParts; ++k) {
      const Vector2d at = (a + (b - a) * (k + 0.5) / kParts).cwiseQuotient(step);
      sum += density(at[0], at[1]) / kParts;
    }
    return sum * (b - a).norm();
  };
  for (const Vector2d& place : {Vector2d(41, 30), Vector2d(90.5, 71.2)})
    march.start(place.cwiseProduct(step), straight);
  march.run({});
  return march.values();
}

/// Of a field that is taken in batches from the same one in order, as a part of the largest value.
double difference(const Density& density, const Vector2d& step) {
  std::vector<double> densities;
  densities.reserve(kSide * kSide);
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) densities.push_back(i < 3 && j < 3 ? kWall : density(i, j));
  const std::vector<double> together = marched(densities, density, step);
  densities[kSide + 1] = 1e-9;  // among walls: nothing comes there
  const std::vector<double> one_by_one = marched(densities, density, step);
  double most = 0, largest = 0;
  for (std::size_t k = 0; k < together.size(); ++k) {
    REQUIRE(std::isfinite(together[k]) == std::isfinite(one_by_one[k]));
    if (!std::isfinite(together[k])) continue;
    most = std::max(most, std::abs(together[k] - one_by_one[k]));
    largest = std::max(largest, together[k]);
  }
  REQUIRE(largest > 10 * step.minCoeff());
  return most / largest;
}

}  // namespace

TEST_CASE("isotropic march: nodes taken together have the values of nodes taken in order") {
  const Density flat = [](double, double) { return 1.0; };
  const Density smooth = [](double x, double y) { return 1.5 + std::sin(0.1 * x) * std::cos(0.07 * y); };
  const Density holes = [](double x, double y) {
    const bool hole = std::fmod(x, 20) > 13 && std::fmod(y + 0.3 * x, 31) > 9;
    return hole ? kWall : 1 + 0.01 * x;
  };
  const Density dear = [](double x, double y) { return std::fmod(x + y, 17) < 6 ? 1e5 : 1.0; };  // far from each other
  for (const Density& density : {flat, smooth, holes, dear}) CHECK(difference(density, Vector2d(1, 1)) < 1e-9);
  // Where two fronts meet in long cells, and in noise, the order matters.
  for (const Density& density : {flat, smooth, holes})
    for (const Vector2d& step : {Vector2d(0.3, 0.1), Vector2d(2, 9)}) CHECK(difference(density, step) < 1e-4);
  Random random;
  std::vector<double> values(kSide * kSide);
  for (double& value : values) value = std::exp(random.uniform(-2, 2));
  const Density noise = [&](double x, double y) {
    return values[static_cast<std::size_t>(std::lround(y)) * kSide + static_cast<std::size_t>(std::lround(x))];
  };
  CHECK(difference(noise, Vector2d(1, 1)) < 1e-4);
}

}  // namespace leastcost::test
