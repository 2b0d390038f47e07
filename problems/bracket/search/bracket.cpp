// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/search/bracket.hpp>

#include <leastcost/framework/base/errors.hpp>
#include "problems/bracket/search/box_search.hpp"
#include "problems/bracket/search/density_medium.hpp"
#include "problems/bracket/search/dual_medium.hpp"
#include "problems/bracket/search/sampled_medium.hpp"

namespace leastcost {
namespace {

using namespace bracket;
using Eigen::AlignedBox2d;
using Eigen::Vector2d;

template <Medium M, int N = M::kDimension>
BoxBracket<N> bracket_in(M medium, const Box<N>& box, const Vector<N>& source, const Vector<N>& target, double upper,
                         const BoxBracketOptions<N>& options) {
  if (!(box.sizes().minCoeff() > 0) || !box.sizes().allFinite())
    throw InputError("a bracket needs a box with finite sides longer than 0");
  if (!box.contains(source) || !box.contains(target)) throw InputError("both ends must be in the box of the bracket");
  return BoxSearch<M>(std::move(medium), box, source, target, upper, options).run();
}

}  // namespace

Bracket bracket_least_cost(const CostDensity& density, const AlignedBox2d& box, const Vector2d& source,
                           const Vector2d& target, double upper, const BracketOptions& options) {
  return bracket_in(DensityMedium<2>(density), box, source, target, upper, options);
}

Bracket bracket_least_cost(const CostDual& dual, const AlignedBox2d& box, const Vector2d& source,
                           const Vector2d& target, double upper, const BracketOptions& options) {
  return bracket_in(DualMedium(dual), box, source, target, upper, options);
}

Bracket bracket_least_cost(const CoordinateCost& cost, const AlignedBox2d& box, const Vector2d& source,
                           const Vector2d& target, double upper, const BracketOptions& options) {
  return bracket_in(SampledMedium(cost, box), box, source, target, upper, options);
}

SpaceBracket bracket_least_cost(const SpaceDensity& density, const Eigen::AlignedBox3d& box,
                                const Eigen::Vector3d& source, const Eigen::Vector3d& target, double upper,
                                const SpaceBracketOptions& options) {
  return bracket_in(DensityMedium<3>(density), box, source, target, upper, options);
}

}  // namespace leastcost
