// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "problems/layers/refracted_ray.hpp"

namespace leastcost {

/// No path that passes the layers of the ray's word in order costs less, unless it costs more than `upper`. Rounded
/// downward (intervals). For vectors y_i no longer than the indices n_i the cost is at least the sum of y_i . (x_{i+1}
/// - x_i); with the slownesses of the ray for y_i it hardly depends on where the crossings x_i are on their planes, for
/// along these the slownesses agree: what they disagree by counts with the farthest place that a path below `upper` can
/// reach.
double word_bound(const LayerStack& stack, const RefractedRay& ray, double upper,
                  std::optional<double> last_index = {});

/// The layers that a path meets in a stack of parallel interfaces: those between its ends, from `bottom` to `top` (none
/// where both ends are on one interface: bottom = top + 1), and what lies on the way to the layer `farthest`, which it
/// reaches and comes back from.
struct Excursion {
  int bottom, top;
  std::optional<int> farthest = {};
};

/// No path costs less that reaches `farthest` and meets no index below those of this excursion. Rounded downward: the
/// dual of Snell's law, docs/numerics.md Sec. 4.2.
double excursion_bound(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                       const Excursion& excursion);

}  // namespace leastcost
