// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "problems/layers/refracted_ray.hpp"

namespace leastcost {

struct FastestRayOptions {
  double tolerance = 1e-9;                        ///< relative: what lies so close to the best is not looked at
  int max_words = 20000;                          ///< that may be solved
  int lowest = 0;                                 ///< layers below it cannot be reached,
  int highest = std::numeric_limits<int>::max();  ///< nor those above
  std::function<bool(const Points&)> allowed = [](const Points&) { return true; };  ///< of a polyline: within a box
  std::function<bool()> stop = [] { return false; };
};

struct FastestRay {
  std::optional<RefractedRay> best;  ///< the cheapest that is allowed
  double lower_bound = 0;            ///< no path between the ends costs less
  int words = 0;                     ///< that were solved
  bool finished = false;             ///< before it was stopped
};

/// The least-cost path of all words, and a bound below all paths. Between parallel interfaces the words are few: some
/// least-cost path goes beyond its ends at most once, to the layer of the least index that it meets. Elsewhere they are
/// searched from the source on, in the order of their lower bounds.
FastestRay fastest_ray(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                       const FastestRayOptions& options = {});

/// Whether each leg lies in the layer of the word that it should.
bool is_in_its_layers(const LayerStack& stack, const RefractedRay& ray);

}  // namespace leastcost
