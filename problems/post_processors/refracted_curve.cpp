// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/post_processors/refracted_curve.hpp"

#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/problems/layers/has_layers.hpp>
#include "problems/layers/snell.hpp"

namespace leastcost {
namespace {

constexpr double kOutOfBox = 1e-12;  ///< of the length: by so much rounding may take a crossing out of a box

/// The costs of the legs of a polyline.
Eigen::VectorXd leg_costs(const LayerStack& stack, const Points& x) {
  Eigen::VectorXd costs(x.cols() - 1);
  for (Index i = 0; i < costs.size(); ++i) {
    const auto layer = stack.layer_of_leg(x.col(i), x.col(i + 1));
    costs[i] = layer ? stack.index(*layer) * (x.col(i + 1) - x.col(i)).norm() : 0;
  }
  return costs;
}

}  // namespace

Points spaced_by_cost(const Points& x, const Eigen::VectorXd& legs, Index columns, Eigen::VectorXd& between) {
  const double total = legs.sum();
  Points points(x.rows(), columns);
  between.resize(columns - 1);
  Index leg = 0;
  double reached = 0, before = 0;  // at the beginning of the leg; at the last point
  for (Index k = 0; k < columns; ++k) {
    const double wanted = total * static_cast<double>(k) / static_cast<double>(columns - 1);
    while (leg + 1 < legs.size() && reached + legs[leg] < wanted) reached += legs[leg++];
    const double share = legs[leg] > 0 ? std::clamp((wanted - reached) / legs[leg], 0.0, 1.0) : 0;
    points.col(k) = x.col(leg) + share * (x.col(leg + 1) - x.col(leg));
    const double here = reached + share * legs[leg];
    if (k > 0) between[k - 1] = here - before;
    before = here;
  }
  points.col(0) = x.col(0);
  points.col(columns - 1) = x.rightCols(1);
  return points;
}

std::string why_no_refraction(const Problem& problem) {
  const auto* cost = find_ability<HasLayers>(*problem.cost);
  if (cost == nullptr) return "needs a cost with layers";
  if (problem.ring || problem.based) return "joins two ends, but this path is a ring";
  const ConstraintManifold& manifold = *problem.manifold;
  const Dimensions d = manifold.dimensions();
  const bool free = manifold.shape() == Shape::flat && d.coordinate == d.ambient && d.tangent == d.ambient &&
                    find_ability<HasChart>(manifold) == nullptr && find_ability<ChecksMoves>(manifold) == nullptr;
  if (!free || d.ambient != cost->layers().dimension())
    return "needs the plane or space, or a box in it, without obstacles";
  return "";
}

const LayerStack& layers_of(const Problem& problem, const std::string& who) {
  if (const std::string why = why_no_refraction(problem); !why.empty()) throw InputError(who + " " + why);
  return find_ability<HasLayers>(*problem.cost)->layers();
}

bool is_in_box(const Problem& problem, const Points& polyline) {
  const double length = (polyline.rightCols(polyline.cols() - 1) - polyline.leftCols(polyline.cols() - 1)).norm();
  return problem.manifold->residual({polyline, {}, false}) <= kOutOfBox * length;
}

void deliver_ray(const LayerStack& stack, const RefractedRay& ray, double least, PostProcessed& current) {
  current.curve = {};
  current.curve.x = without_repeats(ray.x);
  const Eigen::VectorXd legs = leg_costs(stack, current.curve.x);
  current.curve.cost = legs.sum();
  current.chain.u = spaced_by_cost(current.curve.x, legs, current.chain.u.cols(), current.curve_costs);
  current.curve.least_of_class = least;
  double worst = 0;
  for (const Crossing& crossing : measure_crossings(stack, current.curve.x))
    worst = std::max(worst, crossing.mismatch - crossing.rounding);
  current.curve.straightness = -worst;
}

}  // namespace leastcost
