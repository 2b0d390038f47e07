// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "problems/layers/layer_word.hpp"

namespace leastcost {

/// The least-cost path among those that pass the layers of a word in order.
struct RefractedRay {
  LayerWord word;
  Points x;         ///< the source, the crossings, the target: d x (number of layers + 1)
  Points slowness;  ///< index times direction of the legs, as the solve knows them: d x (number of layers)
  double cost = 0;  ///< of the polyline, each leg at the index of its layer
};

/// Minimises the sum of index times length over the places of the crossings on their planes. It is convex, so that the
/// stationary point is the least one; Newton in the coordinates along the planes, from lengths sqrt(l^2 + e^2) that are
/// rounded off by e, which falls from a third of the size to rounding: legs of length zero (a path that touches a plane
/// and comes back) have no derivatives. `word` may be that of a part of a path: then `last_index` stands for the index
/// of its last layer, without which that is its own.
RefractedRay refracted_ray(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                           LayerWord word, std::optional<double> last_index = {});

}  // namespace leastcost
