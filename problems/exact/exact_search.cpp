// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/exact/exact_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "problems/exact/gathered_mesh.hpp"
#include "problems/exact/metric_mesh.hpp"
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

/// The mesh moved to the origin where it lies far from there: the position of an end is then as exact as lengths are.
/// It is moved only along axes on which no coordinate is more than twice another one. Differences of such coordinates
/// are exact (Sterbenz), so that all lengths stay as they were. On other axes it is not far away.
std::optional<MetricMesh> brought_near(const TriangleMesh& mesh) {
  constexpr double kFar = 16;  // times its extent
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.positions()) box.extend(p);
  if (box.isEmpty()) return std::nullopt;
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (!(reach > kFar * box.sizes().maxCoeff())) return std::nullopt;
  Eigen::Vector3d centre = mesh.position(0);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double low = box.min()[axis], high = box.max()[axis];
    const bool alike = low > 0 ? high <= 2 * low : low >= 2 * high;
    if (!alike) centre[axis] = 0;
  }
  return std::optional<MetricMesh>(std::in_place, mesh, Eigen::Matrix3d(Eigen::Matrix3d::Identity()), centre);
}

/// An end of a query on the mesh that is searched, and where it is on the mesh before vertices were gathered.
struct QueryEnd {
  EndPoint end;
  Eigen::Vector3d given;
  std::int32_t face;
};

/// What is known of one pair, from the path that the query began with on.
class PairKnowledge {
 public:
  /// `gathered`: the mesh that is searched, where that is not the given one; null: it is.
  PairKnowledge(const TriangleMesh& mesh, const GatheredMesh* gathered, const QueryEnd& from, const QueryEnd& to,
                const ExactOptions& options)
      : mesh_(&mesh), gathered_(gathered), from_(&from), to_(&to), options_(&options) {
    if (options.start == nullptr) return;
    know(*options.start);
    given_ = result.length;
  }

  void know(SurfacePath path) {
    if (path.points.empty()) return;
    result.length = rounded_up(path);
    result.path = std::move(path);
  }
  /// Of the mesh that is searched.
  void know_found(SurfacePath path) { know(back(std::move(path))); }

  /// No path on the mesh that is searched needs to be longer.
  double upper() const { return result.length + error(); }

  /// For the next run: shorter paths are sought, with the windows that are left.
  QueryLimits limits() const {
    QueryLimits limits = limits_of(*options_);
    limits.upper = upper();
    limits.slack = kSearchShare * options_->tolerance;
    limits.max_windows -= std::min(limits.max_windows, result.windows);
    return limits;
  }

  /// Takes over what a run found; true when nothing more is to be done.
  template <class Real>
  bool take(const Propagation<Real>& run) {
    result.windows += run.windows();
    if (run.found() < result.length * (1 - kSearchShare * options_->tolerance) || result.path.points.empty()) {
      SurfacePath path = back(straightened(*mesh_, run.path()));
      if (!path.points.empty() && rounded_up(path) < result.length) know(std::move(path));
    }
    result.lower_bound = std::max(result.lower_bound, run.lower_bound() - error());
    if (gathered_ != nullptr) result.lower_bound = std::max(result.lower_bound, straight_line());
    result.lower_bound = std::min(result.lower_bound, result.length);
    const double open = result.length - result.lower_bound;
    // Infinite both: there is no path, and that is proved.
    result.gap = result.lower_bound < result.length && result.length > 0 ? open / result.length : 0.0;
    if (std::isinf(result.length) && std::isfinite(result.lower_bound))
      result.gap = std::numeric_limits<double>::infinity();
    const double tolerance =
        std::max(options_->tolerance, rounding_of_places(result.path, result.length, from_->end, to_->end));
    if (result.gap <= tolerance) {
      const bool shorter = std::isfinite(given_) && result.length < given_ * (1 - tolerance);
      result.outcome = shorter ? ExactOutcome::improved : ExactOutcome::proved;
      return true;
    }
    if (run.stopped()) {
      result.outcome = ExactOutcome::bounded;
      result.out_of_memory = run.out_of_memory();
      return true;
    }
    result.outcome = ExactOutcome::blocked;
    result.reason = run.crowded()   ? "more than a million windows reached one edge"
                    : run.blocked() ? "a shorter path could cross a degenerate face"
                                    : "the rounding error is larger than the tolerance";
    return false;
  }

  ExactResult result;

 private:
  double error() const { return gathered_ != nullptr ? gathered_->error() : 0; }
  SurfacePath back(SurfacePath path) const {
    return gathered_ != nullptr ? gathered_->back(std::move(path), from_->given, to_->given, from_->face)
                                : std::move(path);
  }
  double straight_line() const { return (from_->given - to_->given).norm() * (1 - 4 * kRoundingOf<double>); }

  const TriangleMesh* mesh_;
  const GatheredMesh* gathered_;
  const QueryEnd *from_, *to_;
  const ExactOptions* options_;
  double given_ = std::numeric_limits<double>::infinity();
};

}  // namespace

struct ExactSearch::Tables {
  Tables(const TriangleMesh& mesh, const Deadline& deadline)
      : given(mesh),
        near(brought_near(mesh)),
        gathered(GatheredMesh::of(before())),
        edges(gathered ? gathered->mesh() : before(), deadline) {}
  /// The mesh before vertices were gathered.
  const TriangleMesh& before() const { return near ? near->mesh() : given; }
  const GatheredMesh* if_gathered() const { return gathered ? &*gathered : nullptr; }
  double error() const { return gathered ? gathered->error() : 0; }  ///< of distances, length units
  QueryEnd end(const SurfacePoint& p) const {
    QueryEnd found{end_point(edges, p), {}, p.face};
    found.given = found.end.vertex >= 0 ? before().position(found.end.vertex) : before().point(p);
    return found;
  }
  SurfacePath there(SurfacePath path) const { return near ? near->there(std::move(path)) : std::move(path); }
  SurfacePath back(SurfacePath path) const { return near ? near->back(std::move(path)) : std::move(path); }

  const TriangleMesh& given;
  std::optional<MetricMesh> near;        ///< the mesh moved to the origin, on which is searched; none: `given`
  std::optional<GatheredMesh> gathered;  ///< the one that is searched; none: `near` or `given`
  HalfEdges edges;
  Landmarks landmarks;
};

struct ExactSearch::Workspace::Parts {
  explicit Parts(const HalfEdges& mesh) : edges(&mesh), quick(mesh), fronts(mesh) {}

  /// Fronts around the target, for paths shorter than the known one, or than one that is made for it; null where the
  /// straight line is as good.
  FrontBound* aim_fronts(const EndPoint& from, const EndPoint& to, const SurfacePoint& source,
                         const SurfacePoint& target, const Landmarks* landmarks, const StopPredicate& stop,
                         PairKnowledge& known) {
    const double straight = (from.position - to.position).norm();
    if (std::isinf(known.result.length) && FrontBound::is_worth(*edges, straight))
      known.know_found(likely_path(source, target, stop));
    if (std::isinf(known.result.length) || !(straight < kStraight * known.result.length)) return nullptr;
    const LowerBound back(*edges, &from, landmarks);
    fronts.aim(
        from, to, known.upper(), [&back](std::int32_t v) { return back.from_vertex(v); }, stop);
    return fronts.helps() ? &fronts : nullptr;
  }

  /// In double precision; with fronts first in the order of keys. True when nothing more is to be done.
  bool run_quick(const EndPoint& from, const EndPoint& to, const LowerBound& bound, bool with_fronts,
                 PairKnowledge& known) {
    QueryLimits limits = known.limits();
    const std::int64_t by_keys = kByKeys * edges->mesh().vertex_count(), allowed = limits.max_windows;
    if (with_fronts && by_keys < allowed) {
      limits.max_windows = by_keys;
      quick.run(from, &to, bound, limits);
      const bool goes_on = quick.windows() > by_keys && !quick.out_of_memory();
      const bool done = known.take(quick);
      if (known.result.is_proved() || !goes_on) return done;
      limits = known.limits();
      limits.by_distance = true;
    }
    quick.run(from, &to, bound, limits);
    return known.take(quick);
  }

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
  const TriangleMesh& mesh = tables_->given;
  if (landmarks.made_for() != fingerprint(mesh))
    throw InputError(mesh.source() +
                     ": these landmarks were made for another mesh, or for other positions of it, so their distances "
                     "are not bounds here; make them again (make_landmarks)");
  tables_->landmarks = std::move(landmarks);
}

ExactResult ExactSearch::shortest(const SurfacePoint& source, const SurfacePoint& target, Workspace& workspace,
                                  const ExactOptions& options) const {
  const HalfEdges& edges = tables_->edges;
  Workspace::Parts& parts = *workspace.parts_;
  const QueryEnd ends[] = {tables_->end(source), tables_->end(target)};
  const EndPoint &from = ends[0].end, &to = ends[1].end;
  ExactOptions near = options;
  std::optional<SurfacePath> start;
  if (options.start != nullptr) near.start = &start.emplace(tables_->there(*options.start));
  PairKnowledge known(edges.mesh(), tables_->if_gathered(), ends[0], ends[1], near);
  const auto found = [&] {
    known.result.path = tables_->back(std::move(known.result.path));
    return std::move(known.result);
  };
  const Landmarks* const landmarks =
      options.landmarks && tables_->landmarks.count() > 0 ? &tables_->landmarks : nullptr;
  FrontBound* const fronts =
      options.fronts ? parts.aim_fronts(from, to, source, target, landmarks, options.stop, known) : nullptr;
  known.result.bound = "euclid";
  if (landmarks != nullptr) known.result.bound += " + " + std::to_string(landmarks->count()) + " landmarks";
  if (fronts != nullptr) known.result.bound += " + fronts";
  const LowerBound bound(edges, &to, landmarks, fronts);
  if (parts.run_quick(from, to, bound, fronts != nullptr, known)) return found();

  if (!parts.fine) parts.fine = std::make_unique<Propagation<DoubleDouble>>(edges);
  known.result.twice_the_digits = true;
  parts.fine->run(from, &to, bound, known.limits());
  known.take(*parts.fine);
  return found();
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
  const double error = tables_->error();
  limits.upper = options.max_distance * (1 + kSameDistance) + error;
  run.run(from, nullptr, LowerBound(edges, nullptr, nullptr), limits);
  ExactDistances all;
  all.windows = run.windows();
  all.seen_to = std::max(0.0, run.seen_to() - error);
  all.blocked = run.blocked();
  all.stopped = run.stopped();
  all.complete = !all.stopped && !all.blocked;
  all.out_of_memory = run.out_of_memory();
  all.out_of_windows = all.stopped && !all.out_of_memory && run.windows() > options.max_windows;
  for (std::int32_t v = 0; v < edges.mesh().vertex_count(); ++v) {
    const VertexReach& reach = run.reached(v);
    const bool asked_for = reach.at_least <= limits.upper;  // what lies beyond was met by chance
    all.at_least.push_back(std::min(std::max(0.0, reach.at_least - error), all.seen_to));
    all.at_most.push_back(asked_for ? reach.at_most + error : std::numeric_limits<double>::infinity());
    all.distance.push_back(asked_for ? std::clamp(reach.about, all.at_least.back(), all.at_most.back())
                                     : std::numeric_limits<double>::infinity());
  }
  return all;
}

std::vector<SurfacePath> ExactSearch::paths(const SurfacePoint& source, std::span<const std::int32_t> vertices,
                                            Workspace& workspace, const ExactOptions& options) const {
  const HalfEdges& edges = tables_->edges;
  const QueryEnd end = tables_->end(source);
  const EndPoint& from = end.end;
  Propagation<double>& run = workspace.parts_->quick;
  QueryLimits limits = limits_of(options);
  limits.keep_windows = true;
  run.run(from, nullptr, LowerBound(edges, nullptr, nullptr), limits);
  std::vector<SurfacePath> paths;
  paths.reserve(vertices.size());
  for (const std::int32_t v : vertices) {
    SurfacePath path = run.path_to(v);
    if (path.points.size() > 1) path = straightened(edges.mesh(), path);
    if (tables_->gathered)
      path = tables_->gathered->back(std::move(path), end.given, tables_->before().position(v), end.face);
    paths.push_back(tables_->back(std::move(path)));
  }
  return paths;
}

std::uint64_t ExactSearch::made_for() const { return fingerprint(tables_->given); }

Landmarks ExactSearch::make_landmarks(int count, Workspace& workspace, const std::function<bool()>& stop) const {
  const TriangleMesh& mesh = tables_->given;
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
