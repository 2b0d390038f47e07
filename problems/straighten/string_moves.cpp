// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/string_moves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace leastcost {
namespace {

constexpr double kStraight = std::numbers::pi - 1e-10;  // radians; the certificate asks for pi - 1e-9
constexpr double kRounding = 1e-15;                     // relative length
constexpr int kUndecidedLimit = 100;
constexpr std::size_t kShortestShot = 16;  // doors: below, moving vertex by vertex is as fast
constexpr double kShotGain = 1e-6;         // relative length

int corner_of(const TriangleMesh& mesh, std::int32_t face, std::int32_t v) {
  const std::array<std::int32_t, 3>& c = mesh.face(face);
  return c[0] == v ? 0 : c[1] == v ? 1 : 2;
}

}  // namespace

SideOfVertex side_of_vertex(const Unfolding& unfolding, std::int32_t v, const CornerAngles& arrives,
                            const CornerAngles& leaves, bool next_side, double enough,
                            std::vector<std::int32_t>& doors) {
  const TriangleMesh& mesh = unfolding.mesh();
  SideOfVertex side;
  if (arrives.face == leaves.face && (leaves.to_next <= arrives.to_next) == next_side) {
    side.angle = std::abs(leaves.to_next - arrives.to_next);
    return side;
  }
  const int corner = corner_of(mesh, arrives.face, v);
  double sum = next_side ? arrives.to_next : arrives.to_previous;
  std::int32_t edge = 3 * arrives.face + (next_side ? corner : (corner + 2) % 3);
  while (sum < enough) {
    const std::int32_t entry = mesh.across(edge);
    if (entry == TriangleMesh::kNonManifold) side.blocked_by = edge;
    if (entry < 0) return side;
    doors.push_back(edge);
    const bool entered_by_next = mesh.tail(entry) == v;  // the edge v -> next corner of the face entered
    const std::int32_t face = entry / 3;
    if (face == leaves.face) {
      side.angle = sum + (entered_by_next ? leaves.to_next : leaves.to_previous);
      return side;
    }
    if (face == arrives.face) return side;  // all around: the path goes on in another fan of this vertex
    sum += unfolding.corner_angle(face, corner_of(mesh, face, v));
    edge = entered_by_next ? TriangleMesh::previous(entry) : TriangleMesh::next(entry);
  }
  side.angle = sum;
  return side;
}

bool narrow_side(const Unfolding& unfolding, std::int32_t v, const CornerAngles& arrives, const CornerAngles& leaves,
                 std::vector<std::int32_t>& doors) {
  doors.clear();
  std::vector<std::int32_t> other;
  const SideOfVertex a = side_of_vertex(unfolding, v, arrives, leaves, true, kStraight, doors);
  const SideOfVertex b = side_of_vertex(unfolding, v, arrives, leaves, false, kStraight, other);
  if (b.angle < a.angle) std::swap(doors, other);
  if (std::min(a.angle, b.angle) < kStraight) return true;
  const std::int32_t blocked = a.blocked_by >= 0 ? a.blocked_by : b.blocked_by;
  if (blocked >= 0) throw_non_manifold(unfolding.mesh(), blocked);
  return false;
}

bool StringMover::find_moves(TautString& string) {
  const std::size_t count = string.nodes.size();
  has_move_.assign(count, 0);
  if (around_.size() < count) around_.resize(count);
  bool any = false;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    if (!string.nodes[i].changed) continue;
    string.nodes[i].changed = false;
    const CornerAngles &arrives = string.pieces[i - 1].finish, &leaves = string.pieces[i].start;
    if (!narrow_side(puller_->unfolding(), string.nodes[i].end.vertex, arrives, leaves, around_[i])) continue;
    has_move_[i] = 1;
    any = true;
  }
  return any;
}

/// Shorter, or equal to rounding: a bend of 1e-9 costs 1e-18 of the length, which only its angle can tell. The number
/// of such moves is limited, so that rounding cannot make them go round in circles.
bool StringMover::worth_it(double before, double after) {
  if (after < before * (1 - kRounding)) return true;
  return after <= before * (1 + kRounding) && ++undecided_ <= kUndecidedLimit;
}

/// Joins the strips between two nodes, with the fans of the moves at the nodes between, in strip_; their length.
double StringMover::gather(const TautString& string, std::size_t first, std::size_t last) {
  const Unfolding& unfolding = puller_->unfolding();
  double length = 0;
  strip_.first_face = string.pieces[first].strip.first_face;
  strip_.doors.clear();
  for (std::size_t i = first; i < last; ++i) {
    length += string.pieces[i].length;
    for (const Door& door : string.pieces[i].strip.doors) unfolding.append(door, strip_);
    if (i + 1 < last)
      for (const std::int32_t halfedge : around_[i + 1]) unfolding.append(halfedge, strip_);
  }
  return length;
}

/// Replaces the pieces between nodes `first` and `last`, at all of whose inner nodes there is a move. One piece stays.
void StringMover::reroute(TautString& string, std::size_t first, std::size_t last, TautString& out) {
  if (first == last) return;
  if (last == first + 1) {
    out.pieces.push_back(std::move(string.pieces[first]));
    out.nodes.push_back(string.nodes[last]);
    return;
  }
  if (!is_stopped()) {
    const double before = gather(string, first, last);
    const std::size_t nodes = out.nodes.size(), pieces = out.pieces.size();
    const StripEnd from = string.nodes[first].end, to = string.nodes[last].end;
    puller_->pull(from, strip_, to, out);
    double after = 0;
    for (std::size_t i = pieces; i < out.pieces.size(); ++i) after += out.pieces[i].length;
    if (worth_it(before, after)) {
      out.nodes[nodes - 1].changed = true;
      moves_ += static_cast<std::int64_t>(last - first) - 1;
      return;
    }
    out.nodes.resize(nodes);
    out.pieces.resize(pieces);
  }
  for (std::size_t i = first; i < last; ++i) {
    out.pieces.push_back(std::move(string.pieces[i]));
    out.nodes.push_back(string.nodes[i + 1]);
  }
}

/// Replaces what lies between two nodes run by run of nodes with a move.
void StringMover::reroute_runs(TautString& string, std::size_t first, std::size_t last, TautString& out) {
  while (first < last) {
    std::size_t next = first + 1;
    while (next < last && has_move_[next]) ++next;
    reroute(string, first, next, out);
    first = next;
  }
}

/// Keeps the strip of a shot in place of a stretch; false: it is not shorter.
bool StringMover::keep_shot(const TautString& string, std::size_t first, std::size_t last, double before) {
  Shot shot{first, last, {}};
  const StripEnd from = string.nodes[first].end, to = string.nodes[last].end;
  puller_->pull(from, straight_, to, shot.replacement);
  if (shot.replacement.length() >= before * (1 - kShotGain)) return false;
  found_.push_back(std::move(shot));
  ++moves_;
  return true;
}

/// Shots over parts of a stretch with one corner, from large to small.
bool StringMover::try_corners(const TautString& string, std::size_t first, std::size_t last, double before) {
  const std::int32_t corner = string.nodes[first + 1].end.vertex;
  const double doors = static_cast<double>(strip_.doors.size());
  for (double fraction = 0.5; fraction * doors >= kShortestShot; fraction *= 0.25)
    if (shot_.cut_corner(corner, fraction, straight_) && keep_shot(string, first, last, before)) return true;
  return false;
}

/// A straight shot in place of the whole stretch, or one that cuts its only corner; false: none is shorter. What failed
/// once between two vertices is not tried again.
bool StringMover::try_shot(const TautString& string, std::size_t first, std::size_t last) {
  const std::pair<std::int32_t, std::int32_t> ends{string.nodes[first].end.vertex, string.nodes[last].end.vertex};
  if (failed_.count(ends) > 0) return false;
  const double before = gather(string, first, last);
  const StripEnd from = string.nodes[first].end, to = string.nodes[last].end;
  trim(puller_->mesh(), from, to, strip_);
  if (strip_.doors.size() < kShortestShot) return false;
  shot_.aim(from, strip_, to);
  if (shot_.shoot(straight_) && keep_shot(string, first, last, before)) return true;
  if (last - first == 2 && try_corners(string, first, last, before)) return true;
  failed_.insert(ends);
  return false;
}

/// One shot for the whole stretch, else for its halves, and so on.
void StringMover::find_shots(const TautString& string, std::size_t first, std::size_t last) {
  if (last < first + 2 || is_stopped()) return;
  if (try_shot(string, first, last)) return;
  const std::size_t middle = first + (last - first) / 2;
  find_shots(string, first, middle);
  find_shots(string, middle, last);
}

bool StringMover::sweep(TautString& string) {
  if (!find_moves(string)) return false;
  found_.clear();
  for (std::size_t i = 0; shots_ && i < string.pieces.size();) {
    std::size_t last = i + 1;
    while (has_move_[last]) ++last;
    find_shots(string, i, last);
    i = last;
  }
  next_.nodes.clear();
  next_.pieces.clear();
  next_.nodes.push_back(string.nodes.front());
  std::size_t done = 0;
  for (Shot& shot : found_) {
    reroute_runs(string, done, shot.first, next_);
    next_.nodes.back().changed = true;
    std::move(shot.replacement.nodes.begin(), shot.replacement.nodes.end(), std::back_inserter(next_.nodes));
    std::move(shot.replacement.pieces.begin(), shot.replacement.pieces.end(), std::back_inserter(next_.pieces));
    done = shot.last;
  }
  reroute_runs(string, done, string.pieces.size(), next_);
  std::swap(string, next_);
  return true;
}

bool StringMover::straighten(TautString& string, const std::function<bool()>& stop) {
  undecided_ = 0;
  failed_.clear();
  stop_ = stop;
  while (sweep(string))
    if (is_stopped()) return false;
  return true;
}

}  // namespace leastcost
