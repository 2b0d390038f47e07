// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/problems/exact/landmarks.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {

/// What is known about the shortest path between two points of a mesh; never `sampled`.
using ExactOutcome = ProofOutcome;

struct ExactOptions {
  /// Gap that counts as proved, relative; at least what rounding of the path's points may change of its length.
  double tolerance = 1e-9;
  std::int64_t max_windows = std::numeric_limits<std::int64_t>::max();  ///< the search ends where it has made as many
  /// Bytes that windows may take: with the tables of 50,000 triangles less than 2 GB.
  double max_memory = 1.8e9;
  std::function<bool()> stop = {};  ///< true: stop with what is known; empty: never
  /// Told now and then what no path that is still open is shorter than, and the number of windows.
  std::function<void(double, std::int64_t)> watch = {};
  /// Of distances: no farther than this, length units.
  double max_distance = std::numeric_limits<double>::infinity();
  const SurfacePath* start = nullptr;  ///< a path between the ends that is known already
  bool landmarks = true;               ///< use those of the search, if it has any
  /// Bounds by fronts around the target, for ends that are not near each other. They need a start, and make one from a
  /// path over edges where none is given.
  bool fronts = true;
};

/// A shortest path with its bounds.
struct ExactResult {
  ExactOutcome outcome = ExactOutcome::bounded;  ///< what it came to
  /// The shortest path known, straightened; empty where there is none.
  SurfacePath path;
  double length = std::numeric_limits<double>::infinity();  ///< of the path; infinite: the ends are not connected
  double lower_bound = 0;                                   ///< no path on the polyhedron is shorter
  double gap = std::numeric_limits<double>::infinity();     ///< (length - lower_bound) / length
  std::int64_t windows = 0;                                 ///< that were made
  bool twice_the_digits = false;                            ///< double was not enough
  std::string bound;                                        ///< "euclid", and " + 16 landmarks", " + fronts" where used
  bool out_of_memory = false;                               ///< outcome bounded: it was max_memory
  std::string reason;                                       ///< of outcome blocked, in words

  /// Whether the path is proved to be shortest.
  bool is_proved() const { return outcome == ExactOutcome::proved || outcome == ExactOutcome::improved; }
};

/// Distances from the nearest of some points to all vertices, each in [at_least, at_most]. Both are infinite where
/// there is no path; at_most alone where none was found. Within these bounds, which allow for the worst that rounding
/// may do in every face, `distance` is right but for a few roundings.
struct ExactDistances {
  std::vector<double> distance, at_least, at_most;  ///< of every vertex, with bounds below and above
  std::int64_t windows = 0;                         ///< that were made
  /// Every path that is shorter was seen: what is nearer is as exact as rounding lets it be. Infinite: all is known.
  double seen_to = std::numeric_limits<double>::infinity();
  bool stopped = false;         ///< by a budget or a request
  bool complete = true;         ///< false: stopped, or paths run where nothing can be unfolded
  bool blocked = false;         ///< that paths run over a face without height
  bool out_of_memory = false;   ///< stopped by max_memory
  bool out_of_windows = false;  ///< stopped by max_windows
};

/// The shortest paths on one mesh, the polyhedron as it is, with a proof: windows in the order of what they can still
/// give (docs/numerics.md Sec. 5.4). Made once per mesh, which must outlive it; const afterwards and shared by threads,
/// each with a Workspace of its own.
class ExactSearch {
 public:
  /// Throws Interrupted.
  explicit ExactSearch(const TriangleMesh& mesh, const Deadline& deadline = {});
  ~ExactSearch();
  ExactSearch(const ExactSearch&) = delete;
  ExactSearch& operator=(const ExactSearch&) = delete;

  /// Memory that searches use again; for one thread at a time.
  class Workspace {
   public:
    explicit Workspace(const ExactSearch& search);
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;

   private:
    friend class ExactSearch;
    struct Parts;
    std::unique_ptr<Parts> parts_;
  };

  /// The shortest path between two points of the surface.
  ExactResult shortest(const SurfacePoint& source, const SurfacePoint& target, Workspace& workspace,
                       const ExactOptions& options = {}) const;
  ExactDistances distances(const SurfacePoint& source, Workspace& workspace, const ExactOptions& options = {}) const;
  /// From the nearest of several points. Throws InputError where there is none.
  ExactDistances distances(std::span<const SurfacePoint> sources, Workspace& workspace,
                           const ExactOptions& options = {}) const;

  /// Shortest paths from one point to many vertices by one propagation, each straightened; empty where there is none.
  /// Of each window 48 bytes are kept for it; after a stop, or a spent budget, paths need not be the
  /// shortest.
  std::vector<SurfacePath> paths(const SurfacePoint& source, std::span<const std::int32_t> vertices,
                                 Workspace& workspace, const ExactOptions& options = {}) const;

  /// Landmarks far from each other, one propagation each. Fewer where a propagation does not complete, or was stopped.
  Landmarks make_landmarks(int count, Workspace& workspace, const std::function<bool()>& stop = {}) const;
  /// What landmarks of this mesh carry: its fingerprint.
  std::uint64_t made_for() const;
  /// Throws InputError when they were made for another mesh or other positions.
  void use(Landmarks landmarks);

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace leastcost
