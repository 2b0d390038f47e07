// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/begin.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/limits_moves.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
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

/// Points along the first path. A post-processor that finds the way by itself needs no moves between them.
CoordinatePath samples_of_first_path(const Search& search, const Outcome& out) {
  const Problem& problem = out.problem;
  const CoordinatePath& path = out.result.first.path;
  Sampling sampling(point_count(search.options, problem, out.result.first));
  sampling.passes = spacing_passes(search, problem);
  const Deadline& deadline = search.monitor.limit();
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
    place_chain(out.problem, result.first.path, search.monitor.limit());
    result.initial = result.first.path;
    PathEnergy energy(out.problem, 1, search.monitor.limit());
    refuse_infinite(out.problem, energy.ambient(result.initial).x, energy.costs(result.initial));
  };
}

}  // namespace leastcost
