// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/layers/layer_stack.hpp>
#include "problems/layers/refracted_ray.hpp"

namespace leastcost {

/// Why paths cannot be refracted at interfaces; empty: they can.
std::string why_no_refraction(const Problem& problem);

/// The layers of the cost. Throws InputError, which begins with `who`, where it has none, for rings, and where points
/// are not free in R^d or a box.
const LayerStack& layers_of(const Problem& problem, const std::string& who);

/// Whether a polyline stays in the box of the domain.
bool is_in_box(const Problem& problem, const Points& polyline);

/// `columns` points of a polyline, equally spaced in the cost of its legs, and the costs between them.
Points spaced_by_cost(const Points& x, const Eigen::VectorXd& legs, Index columns, Eigen::VectorXd& between);

/// The ray becomes the curve that is delivered, with the chain's points on it. `least`: no path of its word costs less.
void deliver_ray(const LayerStack& stack, const RefractedRay& ray, double least, PostProcessed& current);

}  // namespace leastcost
