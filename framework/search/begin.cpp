// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/begin.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/domain/limits_moves.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/domain/in_parts.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/result/find_path_checks.hpp"
#include "framework/search/based_loop.hpp"
#include "framework/search/name_target.hpp"
#include "framework/search/placement.hpp"
#include "framework/search/reference_cost.hpp"

namespace leastcost {
namespace {

double chain_length(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

/// As many that moves are no longer than the domain's thin obstacles, or parts of a robot, are thick: longer ones keep
/// away from them by a margin of first order. A bound on all motions overstates most, so that a cap costs little.
int count_for_thin_obstacles(const LimitsMoves& domain, const FirstPath& first) {
  constexpr double kFewest = 64, kMost = 200;
  return static_cast<int>(std::clamp(std::ceil(chain_length(first.path.u) / domain.longest_move()), kFewest, kMost));
}

int point_count(const FindOptions& options, const Problem& problem, const FirstPath& first) {
  if (options.points) return *options.points;
  if (first.graph_vertices) return std::max(8, *first.graph_vertices);
  const auto* domain = find_ability<LimitsMoves>(*problem.manifold);
  if (domain == nullptr || problem.ring)
    throw InputError(
        "points: auto counts the vertices of an edge path, or fits moves to the thin parts of a robot, but this domain "
        "has no graph and no robot; give a number");
  return count_for_thin_obstacles(*domain, first);
}

/// Among obstacles the message begins with no_passage.
FirstPath first_path(const Initializer& initializer, const Problem& problem, const Monitor& monitor) {
  try {
    return initializer.first_path(problem, monitor);
  } catch (const InitializationError& error) {
    if (find_ability<ChecksMoves>(*problem.manifold) == nullptr) throw;
    throw InitializationError(std::string("no_passage: ") + error.what());
  }
}

/// Under a length, even steps along the first path are equally spaced on it; that is enough where no solver begins
/// from the points and a post-processor makes the curve.
int spacing_passes(const Search& search, const Problem& problem) {
  const bool on_curve = !search.solver.moves_points() && !search.options.post_processors.empty();
  return on_curve && find_ability<HasConstantMetric>(*problem.cost) != nullptr ? 0 : Sampling::kPasses;
}

/// Whether some point of a chain finds no place as far from the cores of obstacles as moves of this length need it, or
/// none but far from where it is. Such a chain would be pushed and solved in vain.
bool is_crowded(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor) {
  constexpr double kFar = 2;  // longest moves
  const auto* domain = find_ability<FitsSegments>(*problem.manifold);
  if (domain == nullptr) return false;
  const Index first = chain.free_begin(), count = chain.free_count(), moves = chain.u.cols() - 1;
  CoordinatePath pushed{chain.u.middleCols(first, count), {}, true};
  const Projection projection = project(*domain->unfitted(chain), pushed, monitor);
  const double longest = (chain.u.rightCols(moves) - chain.u.leftCols(moves)).colwise().norm().maxCoeff();
  return !projection.failed.empty() || projection.moved > kFar * longest;
}

/// Where the number of points is left to the search: twice as many, up to 800, as long as a chain has too little room.
int count_with_room(const Search& search, const Problem& problem, const CoordinatePath& path, Sampling sampling) {
  constexpr int kMost = 800;
  for (; 2 * sampling.points <= kMost; sampling.points *= 2) {
    const MaybeChain chain = try_sampling(problem, path, sampling, search.monitor.deadline);
    if (chain && !is_crowded(problem, *chain.chain, search.monitor)) break;
  }
  return sampling.points;
}

/// Points along the first path. A post-processor that finds the way by itself needs no moves between them.
CoordinatePath samples_of_first_path(const Search& search, const Outcome& out) {
  const Problem& problem = out.problem;
  const CoordinatePath& path = out.result.first.path;
  Sampling sampling(point_count(search.options, problem, out.result.first));
  sampling.passes = spacing_passes(search, problem);
  const bool fits_moves = !search.options.points && !out.result.first.graph_vertices && search.solver.moves_points();
  if (fits_moves) sampling.points = count_with_room(search, problem, path, sampling);
  const Deadline& deadline = search.monitor.deadline;
  MaybeChain chain = try_sampling(problem, path, sampling, deadline);
  const bool moves_needed = search.solver.moves_points() || !search.finds_its_own();
  if (chain || moves_needed || !std::isfinite(PathEnergy(problem, 1, deadline).cost(path)))
    return std::move(chain).or_throw();
  return sample_evenly(problem, path, sampling.points, deadline);
}

}  // namespace

Begin from_first_path(const Initializer& initializer) {
  return [&initializer](const Search& search, Outcome& out) {
    Result& result = out.result;
    if (initializer.name() == "straight") name_target_over_pole(search, out);
    result.first = first_path(initializer, out.problem, search.monitor);
    check_path(out.problem, result.first.path, out.problem.ring ? 1 : 2, "the first path");
    name_target_of_first_path(search, out);
    cut_at_base(out);
    pin_ends(out.problem, result.first.path);
    result.initial = samples_of_first_path(search, out);
    out.sampled = true;
  };
}

Begin from_chain(const CoordinatePath& chain) {
  return [&chain](const Search& search, Outcome& out) {
    Result& result = out.result;
    result.first.path = chain;
    open_based_chain(out);
    place_chain(out.problem, result.first.path, search.monitor.deadline);
    result.initial = result.first.path;
    PathEnergy energy(out.problem, 1, search.monitor.deadline);
    refuse_infinite(out.problem, energy.ambient(result.initial).x, energy.costs(result.initial));
  };
}

}  // namespace leastcost
