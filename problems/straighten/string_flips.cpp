// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/string_flips.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/straighten/plane_vectors.hpp"

namespace leastcost {
namespace {

constexpr double kFlat = 1e-6;      // radians of curvature that a vertex needs to be tried
constexpr double kGain = 1e-12;     // relative length
constexpr double kHopeless = 0.05;  // relative length lost by the pulled string before it is straightened

double cone_angle(const Unfolding& unfolding, std::int32_t v) {
  double sum = 0;
  for (const std::int32_t f : unfolding.mesh().faces_of_vertex(v)) {
    const std::array<std::int32_t, 3>& c = unfolding.mesh().face(f);
    sum += unfolding.corner_angle(f, c[0] == v ? 0 : c[1] == v ? 1 : 2);
  }
  return sum;
}

}  // namespace

/// The string passes beside v through doors first .. last.
void StringFlipper::add_candidate(std::int32_t v, std::size_t first, std::size_t last, const Eigen::Vector2d& at) {
  const Unfolding& unfolding = puller_->unfolding();
  const TriangleMesh& mesh = puller_->mesh();
  const double seen = angle_between(-at, unfolding.end() - at);
  if (mesh.on_border(v)) return;
  const double cone = unfolding.euclidean() ? mesh.vertex_angle(v) : cone_angle(unfolding, v);
  if (cone > 2 * std::numbers::pi - kFlat || seen <= 0.5 * cone + kFlat) return;
  candidates_.push_back({v, first, last, seen - 0.5 * cone});
}

void StringFlipper::find_candidates(const TautString& string, std::size_t piece) {
  candidates_.clear();
  const TautString::Piece& p = string.pieces[piece];
  if (p.strip.doors.empty()) return;
  Unfolding& unfolding = puller_->unfolding();
  unfolding.lay_out(string.nodes[piece].end, p.strip.doors, string.nodes[piece + 1].end);
  const std::vector<UnfoldedDoor>& doors = unfolding.doors();
  std::size_t left = 0, right = 0;  // where the present left and right vertices began
  for (std::size_t i = 1; i <= doors.size(); ++i) {
    const bool last = i == doors.size();
    if (last || doors[i].left_vertex != doors[left].left_vertex) {
      add_candidate(doors[left].left_vertex, left, i - 1, doors[left].left);
      left = i;
    }
    if (last || doors[i].right_vertex != doors[right].right_vertex) {
      add_candidate(doors[right].right_vertex, right, i - 1, doors[right].right);
      right = i;
    }
  }
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.excess > b.excess; });
}

/// Puts into trial_ the string with one piece led around the other side of a vertex; false: no surface there.
bool StringFlipper::flip(const TautString& string, std::size_t piece, const Candidate& candidate) {
  const TriangleMesh& mesh = puller_->mesh();
  const Unfolding& unfolding = puller_->unfolding();
  const Strip& old = string.pieces[piece].strip;
  Strip strip{old.first_face, {}};
  for (std::size_t i = 0; i < candidate.first_door; ++i) unfolding.append(old.doors[i], strip);
  const std::int32_t v = candidate.vertex, first = old.doors[candidate.first_door].halfedge;
  const std::int32_t goal = mesh.across(old.doors[candidate.last_door].halfedge) / 3;
  // The other edge at v of the face before the first door, and so on around v.
  std::int32_t edge = mesh.tail(first) == v ? TriangleMesh::previous(first) : TriangleMesh::next(first);
  for (std::size_t turns = mesh.faces_of_vertex(v).size(); turns > 0; --turns) {
    const std::int32_t entry = mesh.across(edge);
    if (entry < 0) return false;
    unfolding.append(edge, strip);
    if (entry / 3 == goal) break;
    edge = mesh.tail(entry) == v ? TriangleMesh::previous(entry) : TriangleMesh::next(entry);
    if (turns == 1) return false;
  }
  for (std::size_t i = candidate.last_door + 1; i < old.doors.size(); ++i) unfolding.append(old.doors[i], strip);
  trial_.nodes.assign(string.nodes.begin(), string.nodes.begin() + static_cast<std::ptrdiff_t>(piece) + 1);
  trial_.pieces.assign(string.pieces.begin(), string.pieces.begin() + static_cast<std::ptrdiff_t>(piece));
  const StripEnd from = string.nodes[piece].end, to = string.nodes[piece + 1].end;
  trial_.nodes.back().changed = true;
  puller_->pull(from, strip, to, trial_);
  trial_.nodes.insert(trial_.nodes.end(), string.nodes.begin() + static_cast<std::ptrdiff_t>(piece) + 2,
                      string.nodes.end());
  trial_.pieces.insert(trial_.pieces.end(), string.pieces.begin() + static_cast<std::ptrdiff_t>(piece) + 1,
                       string.pieces.end());
  return true;
}

bool StringFlipper::try_flip(TautString& string, std::size_t piece, const Candidate& candidate,
                             const std::function<bool()>& stop) {
  if (!flip(string, piece, candidate)) return false;
  const double before = string.length();
  if (trial_.length() > before * (1 + kHopeless)) return false;
  try {
    mover_->straighten(trial_, stop);
  } catch (const InputError&) {
    return false;  // the other side holds an edge with three or more faces: leave the string where it is
  }
  if (trial_.length() >= before * (1 - kGain)) return false;
  std::swap(string, trial_);
  ++flips_;
  return true;
}

bool StringFlipper::improve(TautString& string, const std::function<bool()>& stop) {
  for (std::size_t piece = 0; piece < string.pieces.size();) {
    find_candidates(string, piece);
    bool improved = false;
    for (const Candidate& candidate : candidates_) {
      if (stop && stop()) return false;
      improved = try_flip(string, piece, candidate, stop);
      if (improved) break;
    }
    piece = improved ? 0 : piece + 1;
  }
  return true;
}

}  // namespace leastcost
