// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/straighten_ring.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/straighten/ring_funnel.hpp"
#include "problems/straighten/string_flips.hpp"
#include "problems/straighten/string_moves.hpp"
#include "problems/straighten/taut_string.hpp"

namespace leastcost {
namespace {

constexpr double kLengthRounding = 1e-15;  // relative length
constexpr int kIdleLimit = 100;            // rounds that gained less: rounding must not make them go round in circles

/// The same ring, begun in the middle of its longest segment: inside a face, or on an edge that it follows.
SurfacePath begun_in_a_face(const SurfacePath& ring) {
  const std::size_t count = ring.faces.size();
  const auto length = [&](std::size_t i) { return (ring.points[i + 1] - ring.points[i]).squaredNorm(); };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < count; ++i)
    if (length(i) > length(longest)) longest = i;
  SurfacePath path;
  const Eigen::Vector3d middle = (ring.points[longest] + ring.points[longest + 1]) / 2;
  path.points.push_back(middle);
  for (std::size_t k = 0; k < count; ++k) {
    path.faces.push_back(ring.faces[(longest + k) % count]);
    path.points.push_back(ring.points[(longest + k) % count + 1]);
  }
  path.faces.push_back(ring.faces[longest]);
  path.points.push_back(middle);
  return path;
}

/// A ring while it is straightened: a string from its base all around to the base again.
class RingStraightener {
 public:
  RingStraightener(const TriangleMesh& mesh, const StraightenOptions& options)
      : puller_(mesh, options.metric),
        mover_(puller_, false),
        flipper_(puller_, mover_),
        funnel_(puller_.unfolding(), puller_.touching()),
        stop_(options.stop) {}

  StraightenedRing run(const SurfacePath& ring, bool flips) {
    string_ = puller_.from_path(begun_in_a_face(ring));
    State state = settle();
    TautString held;
    while (flips && state == State::bent) {
      held = string_;
      const std::int64_t before = flipper_.flips();
      if (!flipper_.improve(string_, stop_) || flipper_.flips() == before) break;
      state = settle();
    }
    // A flip may push a ring over the bump that holds it: then it stays where it was.
    if (state == State::collapsed && !held.pieces.empty()) {
      std::swap(string_, held);
      state = State::bent;
    }
    StraightenedRing result;
    result.collapsed = state == State::collapsed;
    result.finished = !(stop_ && state == State::moving && stop_());
    result.moves = mover_.moves() + closings_;
    result.flips = flipper_.flips();
    if (state == State::line) result.path = funnel_.line();
    if (state == State::moving || state == State::bent) result.path = puller_.to_path(string_);
    return result;
  }

 private:
  enum class State { moving, bent, line, collapsed };

  const TriangleMesh& mesh() const { return puller_.mesh(); }

  /// Moves the string until it is straight, or gone.
  State settle() {
    State state = State::moving;
    for (int idle = 0; state == State::moving && idle <= kIdleLimit;) {
      const double before = string_.length();
      if (!mover_.straighten(string_, stop_) || (stop_ && stop_())) break;
      state = step();
      if (!(string_.length() < before * (1 - kLengthRounding))) ++idle;
    }
    return state;
  }

  /// The string is straight but for its base. Deals with the base, or makes another node the base.
  State step() {
    if (string_.pieces.empty()) return State::collapsed;
    const StripEnd& base = string_.nodes.front().end;
    if (base.vertex >= 0) {
      const CornerAngles &arrives = string_.pieces.back().finish, &leaves = string_.pieces.front().start;
      if (!narrow_side(puller_.unfolding(), base.vertex, arrives, leaves, fan_)) return State::bent;
    }
    if (string_.pieces.size() == 1) return close();
    if (base.vertex >= 0)
      begin_at(string_.nodes.size() / 2);
    else
      leave_base();
    return State::moving;
  }

  /// Makes an inner node the base, and the base, which is a vertex, an inner node.
  void begin_at(std::size_t node) {
    const auto cut = static_cast<std::ptrdiff_t>(node);
    std::rotate(string_.pieces.begin(), string_.pieces.begin() + cut, string_.pieces.end());
    string_.nodes.pop_back();
    string_.nodes.front().changed = true;
    std::rotate(string_.nodes.begin(), string_.nodes.begin() + cut, string_.nodes.end());
    string_.nodes.push_back(string_.nodes.front());
  }

  /// Joins the pieces at a base that is no vertex; the first inner node becomes the base.
  void leave_base() {
    Strip joined = string_.pieces.back().strip;
    append_all(seam(), joined);
    append_all(string_.pieces.front().strip.doors, joined);
    next_.nodes.assign(std::next(string_.nodes.begin()), std::prev(string_.nodes.end()));
    next_.pieces.assign(std::next(string_.pieces.begin()), std::prev(string_.pieces.end()));
    next_.nodes.back().changed = true;
    const StripEnd from = next_.nodes.back().end, to = next_.nodes.front().end;
    puller_.pull(from, joined, to, next_);
    std::swap(string_, next_);
  }

  /// The string bends at its base alone, away from it, or nowhere: the base is given up.
  State close() {
    ++closings_;
    Strip around = string_.pieces.front().strip;
    append_all(seam(), around);
    switch (funnel_.pull(std::move(around.doors))) {
      case RingFunnel::Outcome::collapsed: return State::collapsed;
      case RingFunnel::Outcome::straight: return State::line;
      case RingFunnel::Outcome::bent: break;
    }
    const StripEnd base = funnel_.bend();
    Strip strip = funnel_.strip();
    string_.nodes.assign(1, {base, true});
    string_.pieces.clear();
    puller_.pull(base, strip, base, string_);
    return State::moving;
  }

  void append_all(const std::vector<Door>& doors, Strip& strip) {
    for (const Door& door : doors) puller_.unfolding().append(door, strip);
  }

  /// Doors from the last face of the string to its first one: around the base, or through the edge it lies on.
  std::vector<Door> seam() const {
    std::vector<Door> doors;
    const StripEnd& base = string_.nodes.front().end;
    if (base.vertex >= 0) {
      for (const std::int32_t halfedge : fan_) doors.push_back(Door{halfedge});
      return doors;
    }
    const std::int32_t last = string_.pieces.back().strip.last_face(mesh()),
                       first = string_.pieces.front().strip.first_face;
    if (last == first) return doors;
    for (std::int32_t h = 3 * last; h < 3 * last + 3; ++h)
      if (mesh().across(h) >= 0 && mesh().across(h) / 3 == first && on_door(mesh(), base, h)) return {Door{h}};
    throw InputError("straightening: the ring does not end where it begins");
  }

  StringPuller puller_;
  StringMover mover_;
  StringFlipper flipper_;
  RingFunnel funnel_;
  std::function<bool()> stop_;
  TautString string_, next_;
  std::vector<std::int32_t> fan_;  // doors around the narrow side of the base
  std::int64_t closings_ = 0;
};

}  // namespace

StraightenedRing straighten_ring(const TriangleMesh& mesh, const SurfacePath& ring, const StraightenOptions& options) {
  if (ring.points.size() != ring.faces.size() + 1 || ring.points.front() != ring.points.back())
    throw InputError("straightening: a ring must end where it begins");
  StraightenedRing result;
  if (ring.faces.empty())
    result.collapsed = true;
  else
    result = RingStraightener(mesh, options).run(ring, options.flips);
  result.initial_length = path_length(ring, options.metric);
  result.final_length = path_length(result.path, options.metric);
  return result;
}

double check_straight_ring(const TriangleMesh& mesh, const SurfacePath& ring, const MetricRoot& metric) {
  if (ring.points.empty() || ring.points.front() != ring.points.back()) return -std::numeric_limits<double>::infinity();
  SurfacePath twice = ring;  // so that the seam lies inside
  twice.points.insert(twice.points.end(), std::next(ring.points.begin()), ring.points.end());
  twice.faces.insert(twice.faces.end(), ring.faces.begin(), ring.faces.end());
  return check_straight(mesh, twice, metric);
}

}  // namespace leastcost
