// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/refract.hpp>

#include <optional>
#include <utility>

#include "problems/layers/fastest_ray.hpp"
#include "problems/layers/ray_bound.hpp"
#include "problems/post_processors/refracted_curve.hpp"

namespace leastcost {
namespace {

constexpr double kTouches = 1e-8;  ///< of the cost: a leg along an interface that is shorter only touches it

/// The first layer of the word in which the ray only touches an interface and comes back; null where there is none.
std::optional<std::size_t> touching_layer(const LayerStack& stack, const RefractedRay& ray) {
  for (std::size_t i = 1; i + 1 < ray.word.size(); ++i) {
    const Index leg = static_cast<Index>(i);
    const double cost = stack.index(ray.word[i]) * (ray.x.col(leg + 1) - ray.x.col(leg)).norm();
    if (ray.word[i - 1] == ray.word[i + 1] && cost <= kTouches * ray.cost) return i;
  }
  return std::nullopt;
}

/// The least path of the word of a polyline. One that only touches an interface is cut short: it is no path of least
/// cost, and the straight leg is one of its neighbours.
std::optional<RefractedRay> refracted(const Problem& problem, const LayerStack& stack, const Points& polyline) {
  const auto word = word_of_polyline(stack, polyline);
  if (!word) return std::nullopt;
  RefractedRay ray = refracted_ray(stack, polyline.leftCols(1), polyline.rightCols(1), *word);
  while (const auto touching = touching_layer(stack, ray)) {
    LayerWord rest = ray.word;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(*touching));
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(*touching));
    ray = refracted_ray(stack, polyline.leftCols(1), polyline.rightCols(1), shortened(stack, rest));
  }
  if (!is_in_its_layers(stack, ray) || !is_in_box(problem, ray.x)) return std::nullopt;
  return ray;
}

}  // namespace

PostProcessed RefractPostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                          const Monitor&) const {
  const LayerStack& stack = layers_of(problem, "refract");
  std::optional<RefractedRay> best = refracted(problem, stack, first.path.u);
  if (current.chain.u.cols() > 2)
    if (auto solved = refracted(problem, stack, current.chain.u); solved && (!best || solved->cost < best->cost))
      best = std::move(solved);
  if (!best) {
    current.notes.emplace_back(
        "refract: the least-cost path through the layers of the first path would leave the domain or pass a place "
        "where interfaces have crossed; the chain is kept");
    return current;
  }
  deliver_ray(stack, *best, word_bound(stack, *best, best->cost), current);
  current.notes.push_back("refract: the path passes the layers " + text(best->word));
  return current;
}

}  // namespace leastcost
