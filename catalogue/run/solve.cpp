// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/run/solve.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/recipes/look_elsewhere.hpp>
#include "catalogue/config/config_facts.hpp"
#include "catalogue/run/preparation.hpp"
#include "catalogue/run/run_clock.hpp"
#include "catalogue/run/run_origin.hpp"
#include "catalogue/run/search.hpp"
#include "catalogue/run/with_notes.hpp"
#include "framework/base/point_text.hpp"
#include "problems/raster/raster_cells.hpp"

namespace leastcost {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kReadOtherwise = 0.02;  // of the cost: the cells and the map between them say different things

/// Says so where the cells of a raster, each constant, make the path cost something else.
void compare_with_cells(RunOutcome& outcome) {
  const auto* map = find_ability<HasRasterCells>(*outcome.parts.problem.cost);
  if (map == nullptr || outcome.result.curve.x.cols() < 2) return;
  const double cost = outcome.result.curve.cost, cells = map->cost_over_cells(outcome.result.curve.x);
  if (!std::isfinite(cost) || std::abs(cells - cost) <= kReadOtherwise * cost) return;
  outcome.parts.notes.push_back(
      fmt::format("this path costs {:.4g} with constant cells, and {:.4g} with the interpolated map ('interpolation: "
                  "bilinear' passes through the values, 'smooth' smooths them)",
                  cells, cost));
}

/// An end that the caller has replaced is where he put it.
void follow(PlacedEnd& placed, const PathEnd& end) {
  if (placed.end.u.size() != end.u.size() || placed.end.u != end.u) placed = {end.u, end, 0};
}

/// The path is solved: what its waypoints lack takes nothing away from it.
void place_waypoints(RunOutcome& outcome) {
  RunParts& parts = outcome.parts;
  if (!parts.waypoints.wanted()) return;
  try {
    outcome.waypoints = place_waypoints(parts.problem, outcome.result, parts.waypoints);
  } catch (const Error& error) {
    parts.notes.push_back(std::string("no waypoints were written: ") + error.what());
    return;
  }
  const std::optional<Clearance>& clearance = outcome.waypoints->clearance;
  if (!outcome.waypoints->touches) return;
  const bool inside = clearance->upper < 0;
  parts.notes.push_back("the straight moves between the waypoints are not collision-free: the move from waypoint " +
                        std::to_string(clearance->segment) + " comes " +
                        short_number(std::abs(inside ? clearance->upper : clearance->lower)) +
                        (inside ? "" : " (possibly)") + " too close to " + clearance->obstacle +
                        "; use more waypoints");
}

/// The same.
void make_trajectory(RunOutcome& outcome) {
  RunParts& parts = outcome.parts;
  if (!parts.trajectory.wanted()) return;
  try {
    outcome.trajectory = make_trajectory(parts.problem, outcome.result, parts.trajectory);
  } catch (const Error& error) {
    parts.notes.push_back(std::string("no trajectory was written: ") + error.what());
    return;
  }
  if (outcome.trajectory->touches)
    parts.notes.push_back("the trajectory rounds the corners of the path and comes " +
                          short_number(std::abs(outcome.trajectory->clearance->upper)) + " too close to " +
                          outcome.trajectory->clearance->obstacle + "; use more points");
}

bool same_end(const PathEnd& a, const PathEnd& b) { return a.u.size() == b.u.size() && a.u == b.u; }

bool same_family(const RunParts& a, const RunParts& b) {
  if (a.windings != b.windings || a.family.size() != b.family.size()) return false;
  for (std::size_t i = 0; i < a.family.size(); ++i)
    if (a.family[i].initializer != b.family[i].initializer) return false;
  return true;
}

/// search(); what it throws for want of a path tells how the configuration was read.
void search_with_notes(RunOutcome& outcome, std::optional<double> max_seconds, const Monitor& monitor) {
  const std::vector<std::string> notes = outcome.parts.notes;
  try {
    search(outcome, max_seconds, monitor);
  } catch (const InitializationError& e) {
    throw InitializationError(with_notes(e.what(), notes));
  } catch (const InputError& e) {
    throw InputError(with_notes(e.what(), notes));
  }
}

/// With the line of a configuration that takes it.
std::string note_on(const OtherWay& way) {
  return fmt::format(
      "another path costs about {:.4g}, {:.2g} % less; to start from it, use 'initializer: {{type: bow, height: {:g}, "
      "angle: {:g}}}'",
      way.cost, 100 * way.less, way.bow.height, way.bow.angle);
}

/// The parts that were replaced after reading, in words.
std::vector<std::string> replaced_parts(const RunParts& parts, const RunParts& as_read) {
  const Problem &now = parts.problem, &then = as_read.problem;
  std::vector<std::string> replaced;
  const auto differs = [&](bool same, const char* what) {
    if (!same) replaced.emplace_back(what);
  };
  differs(now.manifold == then.manifold, "manifold");
  differs(now.cost == then.cost, "cost");
  differs(now.kernel == then.kernel, "kernel");
  differs(same_end(now.source, then.source) && same_end(now.target, then.target), "ends");
  differs(parts.options.points == as_read.options.points && now.ring == then.ring && now.based == then.based, "path");
  differs(parts.initializer == as_read.initializer, "initializer");
  differs(same_family(parts, as_read), "family");
  differs(parts.solver == as_read.solver, "solver");
  differs(parts.options.post_processors == as_read.options.post_processors, "post_process");
  return replaced;
}

}  // namespace

RunOutcome solve(Run run, const Monitor& monitor) {
  if (!run.origin) throw InputError("a run must be made by load_run() or parse_run()");
  if (run.origin->config.has_pairs())
    throw InputError(
        "solve() finds one path, but the configuration has many pairs of ends (ends.pairs): give a 'source' and a "
        "'target', or call solve_pairs()");
  const Problem& problem = run.parts.problem;
  if (!problem.ring && (problem.source.u.size() == 0 || problem.target.u.size() == 0))
    throw InputError("solve() needs both ends: the configuration lacks one, and none was put in");
  if (!run.parts.solver || !run.parts.initializer) throw InputError("the run has no solver or no initializer");
  const Clock::time_point start = Clock::now();
  RunOutcome outcome;
  outcome.name = std::move(run.name);
  outcome.parts = std::move(run.parts);
  outcome.seconds = run.seconds;
  outcome.origin = std::move(run.origin);
  RunParts& parts = outcome.parts;
  if (!parts.problem.ring || parts.problem.based) follow(parts.source, parts.problem.source);
  if (!parts.problem.ring) follow(parts.target, parts.problem.target);
  outcome.replaced = replaced_parts(parts, outcome.origin->parts);
  for (const std::string& part : outcome.replaced)
    parts.notes.push_back(part + ": replaced after the configuration was read");
  double prepared = 0;
  if ((run.max_seconds || monitor.deadline) && asks_for_preparation(parts, monitor.deadline.time().has_value())) {
    const Clock::time_point begin = Clock::now();
    prepare(parts.problem);
    prepared = seconds_since(begin);
  }
  search_with_notes(outcome, run.max_seconds, monitor);
  if (!run.max_seconds && !monitor.deadline && sees_one_way(outcome.origin->config))
    if (const auto other = look_elsewhere(parts.problem, *parts.solver, outcome.result, parts.options.points, monitor))
      parts.notes.push_back(note_on(*other));
  outcome.result.seconds.prepare += prepared;
  outcome.seconds.search = seconds_since(start);
  place_waypoints(outcome);
  make_trajectory(outcome);
  compare_with_cells(outcome);
  outcome.finished = std::chrono::system_clock::now();
  return outcome;
}

}  // namespace leastcost
