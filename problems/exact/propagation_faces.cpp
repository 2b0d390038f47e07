// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/propagation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "problems/exact/propagation_parts.hpp"

namespace leastcost {
using exact::kEpsilon, exact::kInfinity, exact::length_in_plane, exact::value;
namespace {

template <class Real>
Real clamped(const Real& x, const Real& low, const Real& high) {
  return x < low ? low : x > high ? high : x;
}

/// A part widened by less than this, of the image's distance, costs twice that; else it is asked what a way around
/// costs, which takes time.
constexpr double kAround = 1e-12;

/// Beside faces that are nearly without height windows may go round a vertex without end. Else an edge has some
/// hundred, in a lattice with noise ten thousand.
constexpr std::int32_t kMostOverEdge = 1'000'000;

}  // namespace

/// The window of paths that leave a face through its side `from_side`, in coordinates that run from the side's tail or
/// from its head: counted as one of the face behind it, or of each where more than one is.
template <class Real>
void Propagation<Real>::add(std::int32_t from_side, bool from_tail, Window<Real>& w) {
  const std::int32_t behind = mesh_->across(from_side);
  if (behind >= 0) return enter(behind, from_side, from_tail, w);
  if (behind == TriangleMesh::kBorder) return;
  for (const std::int32_t h : forks_.sides(from_side)) {
    Window<Real> into = w;
    if (h != from_side) enter(h, from_side, from_tail, into);
  }
}

template <class Real>
void Propagation<Real>::enter(std::int32_t h, std::int32_t from_side, bool from_tail, Window<Real>& w) {
  const std::int32_t origin = from_tail ? mesh_->tail(from_side) : mesh_->head(from_side);
  const Real length = std::is_same_v<Real, double> ? Real(mesh_->side(h).length) : side(h).length;
  if (mesh_->tail(h) != origin) {
    const Real begin = length - w.end;
    w.end = length - w.begin;
    w.begin = begin;
    w.x = length - w.x;
    w.error += 4 * kRoundingOf<Real> * (value(length) + std::abs(value(w.x)));
  }
  const Real outward = Real(2 * kRoundingOf<Real> * value(length));
  w.begin = clamped(Real(w.begin - outward), Real(0.0), length);
  w.end = clamped(Real(w.end + outward), Real(0.0), length);
  w.rise += 4 * kRoundingOf<Real> * value(length);
  turn_at_ends(h, w);
  if (sabotaged_ && sabotaged(w)) return;
  if (!join(h, length, w) && is_sliver(w, length) && merged(h, length, w)) return;
  const double key = (w.sigma + rest_through(h, w)) * (1 - 2 * kEpsilon) - w.error;
  if (key >= limit_) return;
  if (++edge(h).windows > kMostOverEdge) {
    crowded_ = std::min(crowded_, key);
    return block(key);
  }
  w.halfedge = h;
  ++windows_;
  std::int32_t id = static_cast<std::int32_t>(pool_.size());
  if (free_.empty()) {
    pool_.push_back(w);
  } else {
    id = free_.back();
    free_.pop_back();
    pool_[at(id)] = w;
  }
  edge(h).waiting = id;
  double place = key;
  if (by_distance_) {
    const double x = value(w.x), aside = std::clamp(x, value(w.begin), value(w.end)) - x;
    place = std::min(key, w.sigma + length_in_plane(aside, value(w.height)));
  }
  queue_.push(place, key, id);
}

/// Whether the window is to be left out; makes it narrower else.
template <class Real>
bool Propagation<Real>::sabotaged(Window<Real>& w) const {
  const Real off(sabotage_.crack * value(Real(w.end - w.begin)));
  w.begin = w.begin + off;
  w.end = w.end - off;
  return sabotage_.drop_every > 0 && windows_ % sabotage_.drop_every == sabotage_.drop_every - 1;
}

template <class Real>
EdgeState& Propagation<Real>::edge(std::int32_t h) {
  Slot& slot = slots_[at(h)];
  if (slot.query != query_) {
    slot = {query_, static_cast<std::int32_t>(edges_.size())};
    EdgeState state;
    if (bound_->aims()) {
      state.rest_tail = rest(mesh_->tail(h));
      state.rest_head = rest(mesh_->head(h));
      bound_->look_from(h, state);
    }
    edges_.push_back(state);
  }
  return edges_[at(slot.index)];
}

template <class Real>
double Propagation<Real>::rest_through(std::int32_t h, const Window<Real>& w) {
  return bound_->through(edge(h), mesh_->side(h).length, value(w.begin), value(w.end), {value(w.x), value(w.height)});
}

/// What goes through a vertex that may be flat or a little more may turn there, by what its angle leaves open: it goes
/// on as if the image were off by that. In the plane of the image it is no shorter than the straight line.
template <class Real>
void Propagation<Real>::turn_at_ends(std::int32_t h, Window<Real>& w) const {
  const std::int32_t tail = mesh_->tail(h), head = mesh_->head(h);
  const double x = value(w.x), height = value(w.height), length = mesh_->side(h).length;
  if (mesh_->kind(tail) == VertexKind::flat && !(value(w.begin) > 0))
    w.turned += mesh_->turn_error(tail) * (std::abs(x) + height);
  if (mesh_->kind(head) == VertexKind::flat && !(value(w.end) < length))
    w.turned += mesh_->turn_error(head) * (std::abs(length - x) + height);
}

// ---------------------------------------------------------------- over a face

/// The number of the window among those taken; -1 where nobody asks for paths.
template <class Real>
std::int32_t Propagation<Real>::keep(const Window<Real>& w) {
  if (!keeps_) return -1;
  taken_.push_back({w.halfedge, w.parent, w.root, w.parts, value(w.begin), value(w.end), value(w.x), value(w.height)});
  return static_cast<std::int32_t>(taken_.size()) - 1;
}

template <class Real>
void Propagation<Real>::propagate(std::int32_t waiting) {
  Window<Real> w = pool_[at(waiting)];
  free_.push_back(waiting);
  if (w.halfedge < 0) return;  // joined
  pool_[at(waiting)].halfedge = -1;
  // A shorter way to the root was found since. One to the part itself is seen when its continuations are made.
  if (w.root >= 0 && w.sigma > at_most(w.root)) return;
  const std::int32_t id = keep(w);
  const std::int32_t h = w.halfedge;
  const std::int32_t to_right = TriangleMesh::next(h), to_left = TriangleMesh::previous(h);
  const Side<Real> s = side(h);
  if (target_ != nullptr && target_->vertex < 0) see_target(w, id);
  if (!(value(s.y) > 0)) {
    if (!cross_needle(w, id)) block((w.sigma + rest_through(h, w)) * (1 - 2 * kEpsilon) - w.error);
    return;
  }

  // Where the line from the image to the third corner crosses the edge, and how far rounding may have moved that.
  const double height = value(w.height), y = value(s.y);
  const Real aside = s.x - w.x;
  const Real crossing = w.x + aside * w.height / (s.y + w.height);
  const double depth = height + y, per_depth = 1 / depth, about = std::abs(value(aside)) + depth;
  const double image_error = w.error + 2 * kSideError * kRoundingOf<Real> * about;
  const double off = image_error + w.turned;  // of what comes through the edge
  const double margin = 2 * off < depth ? 2 * off * about * y * per_depth * per_depth +
                                              8 * kRoundingOf<Real> * (value(s.length) + std::abs(value(crossing)))
                                        : kInfinity;
  const double after_begin = value(Real(crossing - w.begin)), before_end = value(Real(w.end - crossing));
  bool left = after_begin > -margin, right = before_end > -margin;
  if (left && right) {
    const double distance = length_in_plane(value(aside), depth);
    if (std::min(after_begin, before_end) < 0) w.rise += around_end(w, after_begin, before_end, {value(s.x), y});
    see_corner(w, id, distance);
    const double below = distance * height * per_depth;  // from the image to the crossing
    // The crossings are compared as doubles.
    const double room = height > 0 ? margin + 2 * w.spread * below * below / height +
                                         4 * kEpsilon * (value(s.length) + std::abs(value(crossing)))
                                   : kInfinity;
    if (after_begin > room && before_end > room) {
      EdgeState& known = edge(h);
      const double least = w.sigma + distance - image_error - 8 * kEpsilon * (w.sigma + distance);
      const double most = w.sigma + distance + w.rise + image_error + 8 * kEpsilon * (w.sigma + distance);
      if (most < known.apex_at_most) {
        known.apex_at_most = most;
        known.apex_crossing = value(crossing);
        known.apex_margin = room;
      } else if (least > known.apex_at_most &&
                 std::abs(value(crossing) - known.apex_crossing) > room + known.apex_margin) {
        (value(crossing) < known.apex_crossing ? right : left) = false;
      }
    }
  }
  const std::int32_t a = mesh_->tail(h), b = mesh_->head(h), c = mesh_->tail(to_left);
  if (left) {
    const Real length = side(to_left).length;
    const Real per_length = Real(1.0) / length;
    const Exit exit{to_left, a, c, b, length, s.x * per_length, s.y * per_length, s.length};
    leave(exit, w.begin, w.end, before_end > -margin, w, id);
  }
  if (right) {
    Window<Real> mirrored = w;
    mirrored.x = s.length - w.x;
    mirrored.error += 4 * kRoundingOf<Real> * (value(s.length) + std::abs(value(w.x)));
    const Real length = side(to_right).length;
    const Real per_length = Real(1.0) / length;
    const Exit exit{to_right, b, c, a, length, s.back * per_length, s.y * per_length, s.length};
    leave(exit, s.length - w.end, s.length - w.begin, after_begin > -margin, mirrored, id);
  }
}

/// Of a face with two corners at one place: the side over which leaves what enters over h, which is as long. -1 for
/// other faces.
template <class Real>
std::int32_t Propagation<Real>::needle_exit(std::int32_t h) const {
  const Eigen::Vector3d& third = mesh_->position(mesh_->tail(TriangleMesh::previous(h)));
  if (third == mesh_->position(mesh_->head(h))) return TriangleMesh::previous(h);
  return third == mesh_->position(mesh_->tail(h)) ? TriangleMesh::next(h) : -1;
}

/// Whether what leaves such a face over this side comes to another face, or to a border. Else it goes round in a ring
/// of needles.
template <class Real>
bool Propagation<Real>::leads_out(std::int32_t side) const {
  for (std::int32_t h = mesh_->across(side); h >= 0;) {
    if (h / 3 == side / 3) return false;
    const std::int32_t exit = needle_exit(h);
    if (exit < 0) return true;
    h = mesh_->across(exit);
  }
  return true;
}

/// A face with two corners at one place has no inside: its two other sides are one segment, and what enters over one of
/// them leaves over the other at the same place. What goes round through the corners goes along edges. False for other
/// faces without height, and beside an edge of three faces, where needles could go round in a circle.
template <class Real>
bool Propagation<Real>::cross_needle(const Window<Real>& w, std::int32_t id) {
  const std::int32_t h = w.halfedge, exit = needle_exit(h);
  if (exit < 0 || mesh_->across(h) < 0 || mesh_->across(exit) == TriangleMesh::kNonManifold) return false;
  Window<Real> next = w;
  next.parent = id;
  next.parts = -1;
  // Coordinates run from the place of the tail of h: in either case the head of the exit is there.
  add(exit, false, next);
  return true;
}

/// The part [b0, b1] of the edge entered, seen on through one exit. `to_far`: b1 goes beyond the third corner.
template <class Real>
void Propagation<Real>::leave(const Exit& exit, const Real& b0, const Real& b1, bool to_far, const Window<Real>& w,
                              std::int32_t id) {
  const Real zero(0.0);
  Window<Real> next;
  next.parent = id;
  next.root = w.root;
  next.sigma = w.sigma;
  next.x = w.x * exit.ux - w.height * exit.uy;
  next.height = w.x * exit.uy + w.height * exit.ux;
  if (!(next.height > zero)) next.height = zero;  // paths cross from the near side: nearer to the truth
  const double height = value(w.height), x = value(w.x), image = std::abs(x) + height;
  next.error = w.error + 2 * kSideError * kRoundingOf<Real> * image;
  next.turned = w.turned;
  const double off = next.error + next.turned;
  const double nx = value(next.x), nh = value(next.height), ux = value(exit.ux), uy = value(exit.uy);
  const double length = value(exit.length);

  const auto landing = [&](const Real& from) {
    const Real across = exit.ux * w.height - exit.uy * (from - w.x);
    return across > zero ? clamped(Real(w.height * from / across), zero, exit.length) : exit.length;
  };
  // How far the landing of a ray may be from where exact numbers would put it: the ray turns about its crossing of the
  // edge entered, by the image's error, and meets the exit at an angle whose sine is nh over the distance `all`. The
  // pieces before and behind the crossing are bounded without a root, from below and from above.
  const auto widening = [&](double from, double t, double all, double& angle) {
    const double before = std::max(height, std::abs(from - x)), sine_by = nh * before;
    if (!(2 * off * all < sine_by)) {
      angle = kInfinity;
      return kInfinity;
    }
    const double beyond = std::abs(t * ux - from) + t * uy + 4 * kEpsilon * all;
    const double by = 2 * off * beyond + 3 * kSideError * kRoundingOf<Real> * (all + t) * before;
    angle = by / (before * all);
    return by * all / sine_by;
  };
  double angle0 = 0, angle1 = 0, wider0 = 0, wider1 = 0;
  next.begin = landing(b0);
  next.end = to_far ? exit.length : landing(b1);
  double t0 = value(next.begin), t1 = value(next.end);
  const double all0 = length_in_plane(t0 - nx, nh), all1 = length_in_plane(t1 - nx, nh);
  if (t0 > 0) wider0 = widening(value(b0), t0, all0, angle0);
  if (!to_far) wider1 = widening(value(b1), t1, all1, angle1);
  next.begin = t0 > wider0 ? Real(next.begin - Real(wider0)) : zero;
  next.end = value(Real(exit.length - next.end)) > wider1 ? Real(next.end + Real(wider1)) : exit.length;
  if (!(next.end > next.begin)) return;
  wider0 = std::min(length, wider0);
  wider1 = std::min(length, wider1);
  next.rise = w.rise + 2 * std::max(wider0, wider1) + 8 * kEpsilon * image;
  if (2 * std::max(wider0, wider1) > kAround * image) [[unlikely]]
    next.rise = w.rise + around_ends(exit, b0, b1, wider0, wider1, w, next) + 8 * kEpsilon * image;
  next.spread = w.spread + std::max(angle0, angle1);

  // Is there a shorter way to all of it by a corner of the face (Xin and Wang 2009)?
  t0 = value(next.begin);
  t1 = value(next.end);
  const double r0 = w.sigma + all0 - wider0, r1 = w.sigma + all1 - wider1;
  const double margin = next.error + 16 * kEpsilon * (r0 + r1 + length);
  if (at_most(exit.near) + t1 < r1 - margin) return;
  if (at_most(exit.far) + (length - t0) < r0 - margin) return;
  const double by_opposite = r0 - margin - at_most(exit.opposite);
  const double px = t0 * ux - value(exit.base), py = t0 * uy;
  if (by_opposite > 0 && (px * px + py * py) * (1 + 8 * kEpsilon) < by_opposite * by_opposite) return;

  add(exit.halfedge, mesh_->tail(exit.halfedge) == exit.near, next);
}

/// By how much a path to what the part of `next` was widened by may be longer than the straight line: there and back
/// along the exit, or over the end of the part entered.
template <class Real>
[[gnu::noinline]] double Propagation<Real>::around_ends(const Exit& exit, const Real& b0, const Real& b1, double wider0,
                                                        double wider1, const Window<Real>& w,
                                                        const Window<Real>& next) const {
  const auto over = [&](double wider, const Real& by, const Real& t) {
    if (!(wider > 0)) return 0.0;
    const exact::PlanePoint to{value(t) * value(exit.ux), value(t) * value(exit.uy)};
    return std::min(2 * wider, exact::detour({value(w.x), -value(w.height)}, next.error, value(by), to));
  };
  return std::max(over(wider0, b0, next.begin), over(wider1, b1, next.end));
}

/// The same to a corner that lies past an end of the part, but within rounding.
template <class Real>
[[gnu::noinline]] double Propagation<Real>::around_end(const Window<Real>& w, double after_begin, double before_end,
                                                       const exact::PlanePoint& corner) const {
  const Real& by = after_begin < before_end ? w.begin : w.end;
  return std::min(-2 * std::min(after_begin, before_end),
                  exact::detour({value(w.x), -value(w.height)}, w.error, value(by), corner));
}

/// The third corner, seen through the part or past its end.
template <class Real>
void Propagation<Real>::see_corner(const Window<Real>& w, std::int32_t id, double distance) {
  const std::int32_t corner = TriangleMesh::previous(w.halfedge), v = mesh_->tail(corner);
  const double rounding = 8 * kEpsilon * (w.sigma + distance) + 2 * kSideError * kRoundingOf<Real> * distance;
  const double least = w.sigma + distance - w.error - rounding;
  const double most = w.sigma + distance + w.rise + w.error + rounding;
  const VertexKind kind = mesh_->kind(v);
  double direction = 0, slack = kInfinity;
  if (least <= at_most(v) && (kind == VertexKind::saddle || kind == VertexKind::border) &&
      distance > 8 * (w.error + w.turned)) {
    const Side<double>& s = mesh_->side(w.halfedge);
    // From the corner: its half-edge leads to (0, 0), the image is at (x, -height).
    const double ax = -s.x, ay = -s.y, ix = value(w.x) - s.x, iy = -value(w.height) - s.y;
    const double angle = std::abs(std::atan2(ax * iy - ay * ix, ax * ix + ay * iy));
    const Corner& place = mesh_->corner(corner);
    direction = place.forward ? place.begin + angle : place.end - angle;
    slack = 2 * (w.error + w.turned) / distance + w.spread + 2 * kSideError * kEpsilon + mesh_->turn_error(v);
  }
  const double to_root = w.root < 0 ? 0 : reach_[at(w.root)].about;
  reach(v, {least, most, to_root + distance, w.sigma}, id, -1, direction, slack);
}

/// The target inside the face that is entered, or on one of its edges.
template <class Real>
void Propagation<Real>::see_target(const Window<Real>& w, std::int32_t id) {
  const std::int32_t face = w.halfedge / 3;
  if (std::find(target_->faces.begin(), target_->faces.end(), face) == target_->faces.end()) return;
  const Eigen::Vector3d& a = mesh_->position(mesh_->tail(w.halfedge));
  const Eigen::Vector3d& b = mesh_->position(mesh_->head(w.halfedge));
  const Eigen::Vector3d from_a = target_->position - a, from_b = target_->position - b, edge = b - a;
  const double length = mesh_->side(w.halfedge).length;
  const bool near_a = from_a.squaredNorm() < from_b.squaredNorm();
  const double tx = edge.dot(from_a) / length;
  const double ty = edge.cross(near_a ? from_a : from_b).norm() / length;
  const double x = value(w.x), height = value(w.height);
  const double place = target_->error + 2 * kSideError * kEpsilon * from_a.norm();
  const double off = w.error + w.turned + place;
  const double distance = length_in_plane(tx - x, height + ty);
  const double crossing = height + ty > 0 ? x + (tx - x) * height / (height + ty) : x;
  const double depth = height + ty;
  const double margin = 2 * off < depth ? 2 * off * (distance + place) / depth + 8 * kEpsilon * length : kInfinity;
  const double beside = std::max({0.0, value(w.begin) - crossing, crossing - value(w.end)});
  if (beside > margin) return;
  const double rounding = 8 * kEpsilon * (w.sigma + distance) + place;
  const double by = value(crossing < value(w.begin) ? w.begin : w.end);
  const double around = std::min(2 * beside, exact::detour({x, -height}, w.error, by, {tx, ty}));
  reach_target(w.sigma + distance - w.error - rounding, w.sigma + distance + w.rise + w.error + around + rounding, id,
               -1);
}

template void Propagation<double>::add(std::int32_t, bool, Window<double>&);
template void Propagation<double>::propagate(std::int32_t);
template bool Propagation<double>::leads_out(std::int32_t) const;
template void Propagation<DoubleDouble>::add(std::int32_t, bool, Window<DoubleDouble>&);
template void Propagation<DoubleDouble>::propagate(std::int32_t);
template bool Propagation<DoubleDouble>::leads_out(std::int32_t) const;

}  // namespace leastcost
