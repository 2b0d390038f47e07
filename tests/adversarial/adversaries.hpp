// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/result/result.hpp>
#include "tests/adversarial/shooting.hpp"

namespace leastcost::test {

/// A problem whose answer is known: made to be right and refused, or wrong and certified.
struct Adversary {
  Problem problem;
  std::shared_ptr<const Initializer> initializer;
  int points = 0;
  /// The locally least path that a result stands for; nothing where the truth is not known.
  std::function<std::optional<TrueGeodesic>(const Result&)> truth;
  /// The width along the path of the narrowest thing that is to be seen, about; units of the cost.
  double feature = std::numeric_limits<double>::infinity();
};

/// A family of them; the same seed always makes the same problem.
struct AdversaryFamily {
  std::string name;
  std::function<Adversary(std::uint64_t seed)> make;
  bool resolved = true;  ///< a segment is shorter than what it has to see: to refuse is too cautious
};
const std::vector<AdversaryFamily>& adversary_families();

/// The true geodesic near a chain on an ellipsoid in its chart.
std::optional<TrueGeodesic> geodesic_near(const Eigen::Vector3d& axes, const Problem& problem, const Result& result);
/// Two random points on the ellipsoid 1 : 1 : 0.2 in its chart.
Problem oblate_pair(std::uint64_t seed);

}  // namespace leastcost::test
