// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/find_path.hpp>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <limits>
#include <utility>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/path_energy.hpp>
#include "framework/based_loop.hpp"
#include "framework/cascade.hpp"
#include "framework/escape_saddle.hpp"
#include "framework/spacing.hpp"

namespace leastcost {
namespace {

/// Runs one stage: tells the monitor, measures its time.
template <class Work>
void stage(Stage stage, const Monitor& monitor, double& seconds, Work work) {
  monitor.report({stage, nullptr});
  const auto start = Monitor::Clock::now();
  work();
  seconds = std::chrono::duration<double>(Monitor::Clock::now() - start).count();
}

/// A first path that is there already.
class GivenPath final : public Initializer {
 public:
  GivenPath(const FirstPath& first, std::string_view name) : first_(first), name_(name) {}
  std::string_view name() const override { return name_; }
  FirstPath first_path(const Problem&, const Monitor&) const override { return first_; }

 private:
  const FirstPath& first_;
  std::string_view name_;
};

/// A ring with a fixed point is an open path from that point to itself.
Result find_based_loop(const Problem& problem, const Initializer& initializer, const Solver& solver,
                       const FindOptions& options, const Monitor& monitor) {
  BasedLoop loop;
  double seconds = 0;
  stage(Stage::initialize, monitor, seconds,
        [&] { loop = cut_at_base(problem, initializer.first_path(problem, monitor)); });
  Result result = find_path(loop.problem, GivenPath(loop.first, initializer.name()), solver, options, monitor);
  result.seconds.initialize += seconds;
  return result;
}

int point_count(const FindOptions& options, const FirstPath& first) {
  if (options.points > 0) return options.points;
  if (!first.graph_vertices)
    throw InputError("points: auto counts the vertices of an edge path, and this domain has no graph; give a number");
  return std::max(8, *first.graph_vertices);
}

/// The chain as a curve, before any post-processing.
PostProcessed chain_as_curve(PathEnergy& energy, const CoordinatePath& path) {
  return {{energy.ambient(path).x, {}, energy.cost(path), {}}, path, energy.costs(path), {}};
}

/// A ring that the solver lost may still be found again from the first path, by a post-processor that certifies itself.
bool has_collapsed(const Result& result, const PostProcessed& processed) {
  return processed.collapsed || (result.solve.termination == Termination::collapsed && !processed.curve.straightness);
}

/// The best path of a solve in which the cost, or another part of the problem, threw or contradicted itself. It is not
/// asked again: nothing is measured about the path.
Result unfinished(Result result, PathEnergy& energy) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  result.costs.setConstant(result.path.segment_count(), kUnknown);
  result.curve_costs = result.costs;
  result.curve = {energy.ambient(result.path).x, {}, kUnknown, {}};
  result.certificate.failures.push_back(
      {std::string(name(result.solve.termination)), "while solving: " + result.solve.message});
  result.notes = result.first.notes;
  return result;
}

Status status_of(const Result& result, bool collapsed, const Monitor& monitor) {
  const Termination end = result.solve.termination;
  if (end == Termination::cancelled || end == Termination::time_limit || monitor.interrupted())
    return Status::interrupted;
  if (collapsed) return Status::collapsed;
  return result.certificate.certified() ? Status::certified : Status::uncertified;
}

}  // namespace

std::string_view name(Status status) {
  switch (status) {
    case Status::certified: return "certified";
    case Status::uncertified: return "uncertified";
    case Status::collapsed: return "collapsed";
    case Status::interrupted: return "interrupted";
  }
  return "unknown";
}

Result find_path(const Problem& problem, const Initializer& initializer, const Solver& solver,
                 const FindOptions& options, const Monitor& monitor) {
  check(problem);
  if (problem.ring && problem.based) return find_based_loop(problem, initializer, solver, options, monitor);
  Result result;
  stage(Stage::initialize, monitor, result.seconds.initialize, [&] {
    result.first = initializer.first_path(problem, monitor);
    pin_ends(problem, result.first.path);
    result.initial = sample_equally(problem, result.first.path, point_count(options, result.first));
  });
  const Index segments = result.initial.segment_count();
  result.initial_cost = PathEnergy(problem, 1).cost(result.initial);
  result.reference_cost =
      options.reference_cost > 0 ? options.reference_cost : result.initial_cost / static_cast<double>(segments);
  if (!(result.reference_cost > 0))
    throw InitializationError("the first path costs nothing: there is nothing to minimise");

  PathEnergy energy(problem, result.reference_cost);
  result.path = result.initial;
  stage(Stage::solve, monitor, result.seconds.solve, [&] {
    result.solve = options.cascade ? solve_by_cascade(problem, solver, result.reference_cost, result.path, monitor)
                                   : solver.solve(energy, result.path, monitor);
    if (!options.escape_saddle) return;
    const int left =
        escape_saddles(energy, solver, options.certificate.index_shift, result.path, result.solve, monitor);
    if (left > 0) result.notes.push_back("escape_saddle: left " + std::to_string(left) + " saddles");
    if (!energy.has_exact_hessian())
      result.notes.emplace_back(
          "escape_saddle: a path on a polyhedron, or under H = s, has no index that could show a saddle");
  });
  if (result.solve.termination == Termination::exception || result.solve.termination == Termination::inconsistent)
    return unfinished(std::move(result), energy);

  const ToCurve to_curve = [&](const CoordinatePath& chain) {
    PostProcessed processed = chain_as_curve(energy, chain);
    for (const PostProcessor* step : options.post_processors)
      processed = step->apply(problem, result.first, std::move(processed), monitor);
    return processed;
  };
  PostProcessed processed;
  stage(Stage::post_process, monitor, result.seconds.post_process, [&] { processed = to_curve(result.path); });
  const bool collapsed = has_collapsed(result, processed);
  if (options.certificate.enabled && !collapsed) {
    assert(options.certifier != nullptr);
    stage(Stage::certify, monitor, result.seconds.certify, [&] {
      result.certificate = certify(problem, result.reference_cost, processed, to_curve, *options.certifier,
                                   options.certificate, monitor);
    });
  }
  result.status = status_of(result, collapsed, monitor);
  result.costs = energy.costs(processed.chain);
  result.path = std::move(processed.chain);
  result.curve = std::move(processed.curve);
  result.curve_costs = std::move(processed.curve_costs);
  result.notes.insert(result.notes.begin(), result.first.notes.begin(), result.first.notes.end());
  result.notes.insert(result.notes.end(), processed.notes.begin(), processed.notes.end());
  return result;
}

}  // namespace leastcost
