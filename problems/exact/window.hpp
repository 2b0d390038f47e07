// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

namespace leastcost {

/// All straight continuations of paths through one root over one row of faces: the part [begin, end] of the edge of
/// `halfedge`, whose face is entered next, and the image of the root unfolded into the plane of that face, at
/// (x, -height) where the edge runs from (0, 0) to (length, 0). Length units.
template <class Real>
struct Window {
  std::int32_t halfedge = -1;  ///< -1: it is no longer open
  std::int32_t parent = -1;    ///< window it came from, by its number among those taken, or -1: it starts at the root
  std::int32_t root = -1;      ///< vertex that the paths bend around, or -1: the source
  std::int32_t parts = -1;     ///< first of the parts that it was joined from, or -1: it is one part
  double sigma = 0;            ///< no path to the root is shorter
  Real begin = 0, end = 0, x = 0, height = 0;
  double error = 0;  ///< the image is this near to where exact numbers would put it
  /// Paths through flat vertices may come from places that are off by this much more: they may turn there, but turning
  /// makes no path shorter.
  double turned = 0;
  /// There is a path to every point of the part that is at most this much longer than sigma and the straight distance
  /// from the image: what the root's own distance, and the widening of the part at each edge, may have cost.
  double rise = 0;
  double spread = 0;  ///< the part reaches beyond what the faces leave free by this angle at most, radians
};

/// What is left of a window that was taken: what a path through it is traced by, half of its memory.
struct Taken {
  std::int32_t halfedge = -1, parent = -1, root = -1, parts = -1;  ///< as in the window; parents were taken before
  double begin = 0, end = 0, x = 0, height = 0;                    ///< likewise
};

/// Of a window that was joined.
struct Part {
  double begin = 0, end = 0;            ///< as in the window
  std::int32_t parent = -1, next = -1;  ///< where it came from; the next part, or -1
};

/// What is known of a vertex that paths were found to.
struct VertexReach {
  std::uint32_t query = 0;                                    ///< the query that this is of
  bool pending = false, fired = false, all_around = false;    ///< as a root: in the queue; has sent windows; everywhere
  double at_least = std::numeric_limits<double>::infinity();  ///< no path found to it is shorter
  double at_most = std::numeric_limits<double>::infinity();   ///< there is a path at most this long
  double about = std::numeric_limits<double>::infinity();     ///< the length itself, but for a few roundings
  double direction = 0;                             ///< from which the shortest one comes, radians in the vertex's fan
  double slack = 0;                                 ///< of that direction
  std::int32_t from_window = -1, from_vertex = -1;  ///< where the path came from; neither: straight from the source
};

/// What every window beside a vertex asks for, apart from the rest: a few of them to a line of memory.
struct VertexGuide {
  double at_most = std::numeric_limits<double>::infinity();  ///< as in its VertexReach
  double rest = -1;                                          ///< lower bound to the target; negative: not yet asked
  std::uint32_t query = 0;
};

/// What one query keeps of an edge, seen by the windows that enter the face of its half-edge.
struct EdgeState {
  /// The target turned into the plane of the edge, beyond it; what is left to it from the two ends at least; bound on
  /// the rounding of all that. Length units.
  double target_x = 0, target_y = 0, rest_tail = 0, rest_head = 0, rounding = 0;
  /// The best window that sees the third corner over the edge: of two such windows the worse one need not go on on the
  /// far side of the better one's ray (Chen and Han 1990).
  double apex_at_most = std::numeric_limits<double>::infinity(), apex_crossing = 0, apex_margin = 0;
  std::int32_t waiting = -1;  ///< the last window that entered over the edge, by its place in memory, or -1
  std::int32_t windows = 0;   ///< number of windows that entered over the edge
};

/// Faults on purpose, for tests that must find them.
struct Sabotage {
  std::int64_t drop_every = 0;  ///< every so many-th window is left out; 0: none
  double crack = 0;             ///< parts are narrower by this share at both ends
};

/// When a query stops before it is done.
struct QueryLimits {
  double upper = std::numeric_limits<double>::infinity();  ///< length of a known path, rounded up
  double slack = 0;                                        ///< paths within this fraction of the best are not sought
  std::int64_t max_windows = std::numeric_limits<std::int64_t>::max();
  /// Bytes that its windows may take, the most that growing takes for a moment counted.
  double max_memory = std::numeric_limits<double>::infinity();
  std::function<bool()> stop = {};  ///< true: stop; empty: never
  /// Told now and then what no open path is shorter than, and how many windows there were; empty: nobody.
  std::function<void(double, std::int64_t)> watch = {};
  bool by_distance = false;   ///< the order of windows: from the source outwards, else by keys
  bool keep_windows = false;  ///< without a target: for paths, too, not for distances alone
  Sabotage sabotage = {};
};

}  // namespace leastcost
