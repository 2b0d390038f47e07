// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/exact/exact_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "problems/exact/propagation.hpp"

namespace leastcost {
namespace {

/// Of the tolerance, the part that ends the search; the rest is for rounding.
constexpr double kSearchShare = 0.5;
/// Where the straight line is as near to the known path as this, it is as good as a bound by fronts.
constexpr double kStraight = 0.97;
/// With fronts, windows per vertex that most queries need fewer of. Where all keys are alike, as on a long strip that
/// can be unrolled, the order of keys goes deep before the filters know anything, and takes many times as many. There
/// the order of distances takes fewest; elsewhere that of keys finds shorter paths sooner.
constexpr std::int64_t kByKeys = 16;
constexpr double kSameDistance = 1e-12;  // relative: rounding leaves nobody out who is as far as the limit

double rounded_up(const SurfacePath& path) {
  return path_length(path) * (1 + static_cast<double>(path.points.size() + 8) * kRoundingOf<double>);
}

/// By how much rounding of its points and ends may change the length of a path, relative: of what is far from the
/// origin positions are known less well than lengths.
double rounding_of_places(const SurfacePath& path, double length, const EndPoint& from, const EndPoint& to) {
  constexpr double kMost = 1e-3, kRoundings = 4;  // of a position, at the ends of each segment
  double largest = 0;
  for (const Eigen::Vector3d& x : path.points) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  const double points =
      kRoundings * std::numeric_limits<double>::epsilon() * largest * static_cast<double>(path.points.size());
  // Above and below: the ends of the bound, and those of the path.
  return length > 0 ? std::min(kMost, (points + 2 * (from.error + to.error)) / length) : 0;
}

/// The path of a propagation, straightened exactly; as it is where straightening is not defined. It is as short as can
/// be already, but for rounding, which may make either the longer one: only the straightened one has its points in
/// order where it runs into a vertex.
SurfacePath straightened(const TriangleMesh& mesh, const SurfacePath& path) {
  constexpr double kRounding = 1e-12;  // relative length
  try {
    StraightenOptions options;
    options.shortcuts = false;
    Straightened result = straighten(mesh, path, options);
    if (result.finished && result.final_length <= result.initial_length * (1 + kRounding))
      return std::move(result.path);
  } catch (const InputError&) {
  }
  return path;
}

QueryLimits limits_of(const ExactOptions& options) {
  QueryLimits limits;
  limits.max_windows = options.max_windows;
  limits.max_memory = options.max_memory;
  limits.stop = options.stop;
  limits.watch = options.watch;
  return limits;
}

}  // namespace

struct ExactSearch::Tables {
  Tables(const TriangleMesh& mesh, const Deadline& deadline) : edges(mesh, deadline) {}
  HalfEdges edges;
  Landmarks landmarks;
};

struct ExactSearch::Workspace::Parts {
  explicit Parts(const HalfEdges& mesh) : edges(&mesh), quick(mesh), fronts(mesh) {}

  /// A path that is likely to be the shortest; empty where none is found.
  SurfacePath likely_path(const SurfacePoint& source, const SurfacePoint& target, const StopPredicate& stop) {
    if (!geodesics) geodesics = std::make_unique<GeodesicSearch>(edges->mesh());
    try {
      return std::move(geodesics->shortest(source, target, {.stop = stop, .routes = 1}).result.path);
    } catch (const InputError&) {  // an edge with three faces on the way
      return {};
    }
  }

  const HalfEdges* edges;
  Propagation<double> quick;
  FrontBound fronts;
  std::unique_ptr<GeodesicSearch> geodesics;        // made when it is needed
  std::unique_ptr<Propagation<DoubleDouble>> fine;  // made when it is needed
};

ExactSearch::ExactSearch(const TriangleMesh& mesh, const Deadline& deadline)
    : tables_(std::make_unique<Tables>(mesh, deadline)) {}
ExactSearch::~ExactSearch() = default;

ExactSearch::Workspace::Workspace(const ExactSearch& search) : parts_(std::make_unique<Parts>(search.tables_->edges)) {}
ExactSearch::Workspace::~Workspace() = default;
ExactSearch::Workspace::Workspace(Workspace&&) noexcept = default;
ExactSearch::Workspace& ExactSearch::Workspace::operator=(Workspace&&) noexcept = default;

void ExactSearch::use(Landmarks landmarks) {
  const TriangleMesh& mesh = tables_->edges.mesh();
  if (landmarks.made_for() != fingerprint(mesh))
    throw InputError(mesh.source() +
                     ": these landmarks were made for another mesh, or for other positions of it, so their distances "
                     "are not bounds here; make them again (make_landmarks)");
  tables_->landmarks = std::move(landmarks);
}

ExactResult ExactSearch::shortest(const SurfacePoint& source, const SurfacePoint& target, Workspace& workspace,
                                  const ExactOptions& options) const {
  const HalfEdges& edges = tables_->edges;
  const TriangleMesh& mesh = edges.mesh();
  Workspace::Parts& parts = *workspace.parts_;
  const EndPoint from = end_point(edges, source), to = end_point(edges, target);
  const bool with_landmarks = options.landmarks && tables_->landmarks.count() > 0;
  ExactResult result;
  double start = std::numeric_limits<double>::infinity();
  if (options.start != nullptr) {
    result.path = *options.start;
    result.length = start = rounded_up(result.path);
  }
  FrontBound* fronts = nullptr;
  const double straight = (from.position - to.position).norm();
  if (options.fronts) {
    if (options.start == nullptr && FrontBound::is_worth(edges, straight)) {
      result.path = parts.likely_path(source, target, options.stop);
      if (!result.path.points.empty()) result.length = rounded_up(result.path);
    }
    if (std::isfinite(result.length) && straight < kStraight * result.length) {
      parts.fronts.aim(from, to, result.length, options.stop);
      if (parts.fronts.helps()) fronts = &parts.fronts;
    }
  }
  result.bound = "euclid";
  if (with_landmarks) result.bound += " + " + std::to_string(tables_->landmarks.count()) + " landmarks";
  if (fronts != nullptr) result.bound += " + fronts";
  const LowerBound bound(edges, &to, with_landmarks ? &tables_->landmarks : nullptr, fronts);
  // What a propagation found is taken over; true when nothing more is to be done.
  const auto take = [&](const auto& run) {
    result.windows += run.windows();
    if (run.found() < result.length * (1 - kSearchShare * options.tolerance) || result.path.points.empty()) {
      SurfacePath path = straightened(mesh, run.path());
      const double length = path.points.empty() ? std::numeric_limits<double>::infinity() : rounded_up(path);
      if (length < result.length) {
        result.length = length;
        result.path = std::move(path);
      }
    }
    result.lower_bound = std::min(std::max(result.lower_bound, run.lower_bound()), result.length);
    const double open = result.length - result.lower_bound;
    // Infinite both: there is no path, and that is proved.
    result.gap = result.lower_bound < result.length && result.length > 0 ? open / result.length : 0.0;
    if (std::isinf(result.length) && std::isfinite(result.lower_bound))
      result.gap = std::numeric_limits<double>::infinity();
    const double tolerance = std::max(options.tolerance, rounding_of_places(result.path, result.length, from, to));
    if (result.gap <= tolerance) {
      result.outcome = result.length < start * (1 - tolerance) && std::isfinite(start) ? ExactOutcome::improved
                                                                                       : ExactOutcome::proved;
      return true;
    }
    if (run.stopped()) {
      result.outcome = ExactOutcome::bounded;
      result.out_of_memory = run.out_of_memory();
      return true;
    }
    result.outcome = ExactOutcome::blocked;
    result.reason = run.blocked() ? "a shorter path could cross a degenerate face"
                                  : "the rounding error is larger than the tolerance";
    return false;
  };

  QueryLimits limits = limits_of(options);
  limits.upper = result.length;
  limits.slack = kSearchShare * options.tolerance;
  const std::int64_t by_keys = kByKeys * mesh.vertex_count(), allowed = limits.max_windows;
  if (fronts != nullptr && by_keys < allowed) {
    limits.max_windows = by_keys;
    parts.quick.run(from, &to, bound, limits);
    limits.by_distance = parts.quick.windows() > by_keys && !parts.quick.out_of_memory();
    if (take(parts.quick) && (result.is_proved() || !limits.by_distance)) return result;
    limits.upper = result.length;
    limits.max_windows = allowed - std::min(allowed, result.windows);
  }
  if (fronts == nullptr || by_keys >= allowed || limits.by_distance) {
    parts.quick.run(from, &to, bound, limits);
    if (take(parts.quick)) return result;
  }
  if (!parts.fine) parts.fine = std::make_unique<Propagation<DoubleDouble>>(edges);
  limits.upper = result.length;
  limits.max_windows = allowed - std::min(allowed, result.windows);
  result.twice_the_digits = true;
  parts.fine->run(from, &to, bound, limits);
  take(*parts.fine);
  return result;
}

ExactDistances ExactSearch::distances(const SurfacePoint& source, Workspace& workspace,
                                      const ExactOptions& options) const {
  return distances(std::span<const SurfacePoint>(&source, 1), workspace, options);
}

ExactDistances ExactSearch::distances(std::span<const SurfacePoint> sources, Workspace& workspace,
                                      const ExactOptions& options) const {
  if (sources.empty()) throw InputError("distances need at least one source");
  const HalfEdges& edges = tables_->edges;
  std::vector<EndPoint> from;
  from.reserve(sources.size());
  for (const SurfacePoint& source : sources) from.push_back(end_point(edges, source));
  Propagation<double>& run = workspace.parts_->quick;
  QueryLimits limits = limits_of(options);
  limits.upper = options.max_distance * (1 + kSameDistance);
  run.run(from, nullptr, LowerBound(edges, nullptr, nullptr), limits);
  ExactDistances all;
  all.windows = run.windows();
  all.seen_to = run.seen_to();
  all.blocked = run.blocked();
  all.stopped = run.stopped();
  all.complete = !all.stopped && !all.blocked;
  all.out_of_memory = run.out_of_memory();
  all.out_of_windows = all.stopped && !all.out_of_memory && run.windows() > options.max_windows;
  for (std::int32_t v = 0; v < edges.mesh().vertex_count(); ++v) {
    const VertexReach& reach = run.reached(v);
    const bool asked_for = reach.at_least <= limits.upper;  // what lies beyond was met by chance
    all.at_least.push_back(std::min(reach.at_least, all.seen_to));
    all.at_most.push_back(asked_for ? reach.at_most : std::numeric_limits<double>::infinity());
    all.distance.push_back(asked_for ? std::clamp(reach.about, all.at_least.back(), all.at_most.back())
                                     : std::numeric_limits<double>::infinity());
  }
  return all;
}

std::vector<SurfacePath> ExactSearch::paths(const SurfacePoint& source, std::span<const std::int32_t> vertices,
                                            Workspace& workspace, const ExactOptions& options) const {
  const HalfEdges& edges = tables_->edges;
  const EndPoint from = end_point(edges, source);
  Propagation<double>& run = workspace.parts_->quick;
  QueryLimits limits = limits_of(options);
  limits.keep_windows = true;
  run.run(from, nullptr, LowerBound(edges, nullptr, nullptr), limits);
  std::vector<SurfacePath> paths;
  paths.reserve(vertices.size());
  for (const std::int32_t v : vertices) {
    SurfacePath path = run.path_to(v);
    paths.push_back(path.points.size() > 1 ? straightened(edges.mesh(), path) : std::move(path));
  }
  return paths;
}

std::uint64_t ExactSearch::made_for() const { return fingerprint(tables_->edges.mesh()); }

Landmarks ExactSearch::make_landmarks(int count, Workspace& workspace, const std::function<bool()>& stop) const {
  const TriangleMesh& mesh = tables_->edges.mesh();
  Landmarks landmarks(fingerprint(mesh), static_cast<std::size_t>(mesh.vertex_count()));
  std::vector<double> nearest(static_cast<std::size_t>(mesh.vertex_count()), std::numeric_limits<double>::infinity());
  std::int32_t next = 0;
  // The first run only finds a vertex far from the others.
  for (int i = -1; i < count; ++i) {
    const ExactDistances all = distances(vertex_point(mesh, next), workspace, {.stop = stop});
    if (!all.complete) break;
    if (i >= 0) landmarks.add(next, all.at_least, all.at_most);
    double farthest = 0;
    for (std::size_t v = 0; v < nearest.size(); ++v) {
      const double distance = std::isfinite(all.at_most[v]) ? all.at_most[v] : nearest[v];
      if (i >= 0) nearest[v] = std::min(nearest[v], distance);
      const double rank = i < 0 ? all.at_most[v] : nearest[v];
      if (std::isfinite(rank) && rank > farthest) {
        farthest = rank;
        next = static_cast<std::int32_t>(v);
      }
    }
    if (!(farthest > 0)) break;
  }
  return landmarks;
}

}  // namespace leastcost
