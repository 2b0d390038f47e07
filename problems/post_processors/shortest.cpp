// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/shortest.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "framework/base/point_text.hpp"
#include "problems/mesh/mesh_curve.hpp"
#include "problems/post_processors/search_keeper.hpp"
#include "problems/post_processors/search_time.hpp"

namespace leastcost {
namespace {

constexpr std::int32_t kSmallMesh = 20000;           // vertices up to which a proof goes to its end by default
constexpr std::int64_t kLargeMeshWindows = 4000000;  // above: a second, 400 MB at most
constexpr std::int64_t kMostWindows = 10000000;      // a GB
constexpr double kShorter = 1e-9;                    // relative length that makes another class
// What is built before the first window does not look at the clock. Seconds per face, of two cores that are busy.
constexpr double kTables = 1e-6, kMetricMesh = 1e-6, kEdgeGraph = 1e-6;

GlobalBudget budget_of(const GlobalProof& proof, const TriangleMesh& mesh) {
  GlobalBudget budget;
  if (const auto* given = std::get_if<GlobalBudget>(&proof)) budget = *given;
  if (!budget.max_windows)
    budget.max_windows = static_cast<int>(std::holds_alternative<GlobalAuto>(proof) && mesh.vertex_count() > kSmallMesh
                                              ? kLargeMeshWindows
                                              : kMostWindows);
  return budget;
}

/// Whether something that takes so long would end after the deadline.
bool is_too_long(double seconds, const Deadline& end) {
  return end && std::chrono::duration<double>(*end - Monitor::Clock::now()).count() < seconds;
}

/// Why a proof came to no end, and what would take it on.
std::string reason_of(const ExactResult& found, const GlobalBudget& budget) {
  if (found.outcome != ExactOutcome::bounded) return found.reason;
  if (found.out_of_memory)
    return "the windows would take more than 1.8 GB of memory (to allow more, set certificate: {global: {max_windows: "
           "..}} above " +
           std::to_string(kMostWindows) + ")";
  if (found.windows > *budget.max_windows)
    return "the budget of " + std::to_string(*budget.max_windows) +
           " windows is used up (to raise it, set certificate: {global: {max_windows: ..}})";
  return "the time is used up (to continue, increase max_seconds)";
}

/// The path becomes the curve that is delivered, with the chain's points on it.
void deliver_path(const Problem& problem, const TriangleMesh& mesh, const SurfacePath& path, const MetricRoot& metric,
                  PostProcessed& current) {
  const int columns = static_cast<int>(current.chain.u.cols());
  current.curve = as_curve(problem, path);
  current.curve.straightness = check_straight(mesh, path, metric);
  current.chain = coordinate_path(problem, mesh, resample(mesh, path, columns, metric));
  pin_ends(problem, current.chain);
  current.curve_costs = costs_along(problem, current.curve, current.chain);
}

/// Where the search did not come to its end, the shortest path may be of another class than the best that is known: the
/// better of two more that are only straightened takes its place where it is shorter.
void try_other_starts(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                      const StopPredicate& stop, ExactResult& found) {
  Geodesic other;
  try {
    other = GeodesicSearch(mesh).shortest(from, to, {.stop = stop});
  } catch (const InputError&) {  // an edge with three faces on both ways
    return;
  }
  if (!other.found() || !other.result.finished || !(other.result.final_length < found.length * (1 - kShorter))) return;
  found.path = std::move(other.result.path);
  found.length = other.result.final_length;
  found.lower_bound = std::min(found.lower_bound, found.length);
  found.gap = (found.length - found.lower_bound) / found.length;
}

}  // namespace

ShortestPostProcessor::ShortestPostProcessor(GlobalProof proof)
    : proof_(std::move(proof)), keeper_(std::make_shared<SearchKeeper>()) {}

PostProcessed ShortestPostProcessor::apply(const Problem& problem, const FirstPath&, PostProcessed current,
                                           const Monitor& monitor) const {
  const TriangleMesh& mesh = mesh_of(problem, "post-processor shortest").mesh();
  const std::optional<MetricRoot> metric = constant_metric(problem);
  if (!metric) throw InputError("shortest unfolds the mesh, which needs a cost with a constant metric");
  if (current.chain.ring || problem.based) throw InputError("shortest joins two ends, but this path is a ring");
  if (std::holds_alternative<GlobalOff>(proof_) || monitor.interrupted()) return current;
  // Beside an edge of three faces nothing may have been straightened; the search takes such edges as they are.
  const bool straightened = current.curve.straightness.has_value();
  if (!straightened && mesh.non_manifold_edges().empty()) return current;
  const auto begin = Monitor::Clock::now();
  const GlobalBudget budget = budget_of(proof_, mesh);
  ExactOptions options;
  options.stop = stop_of_search(budget, monitor);
  const double faces = mesh.face_count(), tables = faces * (kTables + (*metric ? kMetricMesh : 0));
  if (!keeper_->holds(problem, *metric) && is_too_long(tables, end_of_search(budget, monitor))) {
    current.notes.emplace_back("shortest: there was no time left for the tables of a proof; increase max_seconds");
    return current;
  }
  const std::shared_ptr<KeptSearch> kept = keeper_->search_for(problem, mesh, *metric, budget, options.stop);
  const MetricMesh* turned = kept->turned();
  SurfacePath start;
  if (straightened) start = as_surface_path(current.curve);
  if (turned && straightened) start = turned->there(std::move(start));
  const std::vector<SurfacePoint> points = surface_points(mesh, current.chain);
  options.tolerance = budget.tolerance;
  options.max_windows = *budget.max_windows;
  if (options.max_windows > kMostWindows) options.max_memory = std::numeric_limits<double>::infinity();
  if (straightened) options.start = &start;
  ExactSearch::Workspace workspace = kept->borrow();
  ExactResult found = kept->search().shortest(points.front(), points.back(), workspace, options);
  kept->give_back(std::move(workspace));
  // Paths are known on the mesh of the search, whose positions are turned by the metric.
  const StopPredicate spent = [&monitor] { return monitor.interrupted(); };
  if (!found.is_proved() && !is_too_long(faces * kEdgeGraph, monitor.deadline))
    try_other_starts(turned ? turned->mesh() : mesh, points.front(), points.back(), spent, found);

  const double before = current.curve.cost;
  if (!straightened) {
    if (found.path.faces.empty()) return current;
    deliver_path(problem, mesh, turned ? turned->back(std::move(found.path)) : found.path, *metric, current);
    current.notes.emplace_back(
        "shortest: the first path crosses an edge with three or more faces; a path that the search over all paths "
        "found "
        "is delivered");
  } else if (found.length < before * (1 - budget.tolerance)) {
    deliver_path(problem, mesh, turned ? turned->back(std::move(found.path)) : found.path, *metric, current);
    current.notes.push_back(
        "shortest: a shorter path than the straightened one was found and is delivered; the straightened one was "
        "longer by " +
        short_number(100 * (before / current.curve.cost - 1)) + " %");
  }
  GlobalBound& global = current.curve.global.emplace();
  global.proved = found.is_proved();
  global.outcome = found.outcome;
  global.lower_bound = std::min(found.lower_bound, current.curve.cost);  // measured elsewhere, hence rounded anew
  global.gap = found.gap;
  global.steps = found.windows;
  global.bound = found.bound;
  if (!global.proved) global.reason = reason_of(found, budget);
  global.seconds = std::chrono::duration<double>(Monitor::Clock::now() - begin).count();
  return current;
}

}  // namespace leastcost
