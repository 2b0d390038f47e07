// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "problems/straighten/string_shot.hpp"
#include "problems/straighten/strip.hpp"
#include "problems/straighten/taut_string.hpp"

namespace leastcost {

/// What lies on one side of a path at a vertex it goes through.
struct SideOfVertex {
  double angle = std::numeric_limits<double>::infinity();  ///< infinite: no surface that connects the two pieces
  std::int32_t blocked_by = -1;  ///< halfedge of an edge with three or more faces met before the angle was enough
};

/// Walks around vertex v from the piece that arrives to the piece that leaves, over the edge towards the next corner
/// (`next_side`) or the previous one, and appends the edges crossed to `doors`. Stops as soon as the angle is `enough`.
SideOfVertex side_of_vertex(const Unfolding& unfolding, std::int32_t v, const CornerAngles& arrives,
                            const CornerAngles& leaves, bool next_side, double enough,
                            std::vector<std::int32_t>& doors);

/// The doors around the narrower side of a vertex that a path goes through, when that side has an angle below pi;
/// false: neither has. Throws InputError when a side that may be narrow holds an edge with three or more faces.
bool narrow_side(const Unfolding& unfolding, std::int32_t v, const CornerAngles& arrives, const CornerAngles& leaves,
                 std::vector<std::int32_t>& doors);

/// Moves a string over vertices until it is straight everywhere.
class StringMover {
 public:
  /// `shots`: long strips are replaced by straight shots where that is shorter, before they are moved vertex by vertex.
  StringMover(StringPuller& puller, bool shots) : puller_(&puller), shots_(shots), shot_(puller.unfolding()) {}

  /// Reroutes the string around every vertex where a side has an angle below pi, sweep by sweep, each sweep only where
  /// something changed. The length never grows. False: stopped before it was straight.
  bool straighten(TautString& string, const std::function<bool()>& stop);
  std::int64_t moves() const { return moves_; }

 private:
  struct Shot {
    std::size_t first, last;  // nodes
    TautString replacement;   // without the first node
  };

  bool sweep(TautString& string);
  bool is_stopped() const { return stop_ && stop_(); }
  bool find_moves(TautString& string);
  double gather(const TautString& string, std::size_t first, std::size_t last);
  void reroute(TautString& string, std::size_t first, std::size_t last, TautString& out);
  void reroute_runs(TautString& string, std::size_t first, std::size_t last, TautString& out);
  bool worth_it(double before, double after);

  void find_shots(const TautString& string, std::size_t first, std::size_t last);
  bool try_shot(const TautString& string, std::size_t first, std::size_t last);
  bool try_corners(const TautString& string, std::size_t first, std::size_t last, double before);
  bool keep_shot(const TautString& string, std::size_t first, std::size_t last, double before);

  StringPuller* puller_;
  bool shots_;
  StringShot shot_;
  std::vector<std::vector<std::int32_t>> around_;  // per node: the doors of its move, if it has one
  std::vector<char> has_move_;
  std::vector<Shot> found_;                                 // of this sweep, in order
  std::set<std::pair<std::int32_t, std::int32_t>> failed_;  // ends of shots that were not shorter
  TautString next_;
  Strip strip_, straight_;
  std::function<bool()> stop_;  // of the straightening in hand
  std::int64_t moves_ = 0;
  int undecided_ = 0;  // moves whose gain was below rounding
};

}  // namespace leastcost
