// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/propagation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = kRoundingOf<double>;
/// Values are held apart by this much, relative, so that two roundings of one distance are one distance.
constexpr double kCushion = 1e-13;
constexpr std::int64_t kLook = 256;  // windows between two looks at the clock

double length_in_plane(double x, double y) { return std::sqrt(x * x + y * y); }

template <class Real>
double value(const Real& x) {
  return static_cast<double>(x);
}

template <class Real>
Real clamped(const Real& x, const Real& low, const Real& high) {
  return x < low ? low : x > high ? high : x;
}

bool same_ends(const HalfEdges& mesh, std::int32_t h, std::int32_t g) {
  return (mesh.tail(h) == mesh.tail(g) && mesh.head(h) == mesh.head(g)) ||
         (mesh.tail(h) == mesh.head(g) && mesh.head(h) == mesh.tail(g));
}

}  // namespace

template <class Real>
Propagation<Real>::Propagation(const HalfEdges& mesh)
    : mesh_(&mesh),
      reach_(at(mesh.mesh().vertex_count())),
      apex_(3 * static_cast<std::size_t>(mesh.mesh().face_count())) {}

template <class Real>
Side<Real> Propagation<Real>::side(std::int32_t h) const {
  if constexpr (std::is_same_v<Real, double>) return mesh_->side(h);
  return make_side<Real>(mesh_->position(mesh_->tail(h)), mesh_->position(mesh_->head(h)),
                         mesh_->position(mesh_->tail(TriangleMesh::previous(h))));
}

template <class Real>
VertexReach& Propagation<Real>::touch(std::int32_t v) {
  VertexReach& reach = reach_[at(v)];
  if (reach.query != query_) reach = VertexReach{.query = query_};
  return reach;
}

template <class Real>
void Propagation<Real>::push(double key, std::int32_t id) {
  queue_.push_back({key, id});
  std::push_heap(queue_.begin(), queue_.end());
}

template <class Real>
void Propagation<Real>::block(double key) {
  blocked_ = std::min(blocked_, key);
}

template <class Real>
double Propagation<Real>::lower_bound() const {
  const double least = std::min({limit_, target_at_least_, blocked_, stopped_ ? open_ : kInfinity});
  return std::max(0.0, least);
}

template <class Real>
void Propagation<Real>::run(const EndPoint& source, const EndPoint* target, const LowerBound& bound,
                            const QueryLimits& limits) {
  ++query_;
  pool_.clear();
  free_.clear();
  queue_.clear();
  source_ = &source;
  target_ = target;
  bound_ = &bound;
  best_ = limits.upper;
  slack_ = limits.slack;
  limit_ = best_ * (1 - slack_);
  target_at_least_ = target_at_most_ = blocked_ = fork_ = kInfinity;
  target_window_ = target_vertex_ = -1;
  open_ = 0;
  stopped_ = false;
  windows_ = 0;

  start(source);
  std::int64_t steps = 0;
  while (!queue_.empty()) {
    const Entry entry = queue_.front();
    if (entry.key >= limit_) break;
    if (windows_ > limits.max_windows || (++steps % kLook == 0 && limits.stop && limits.stop())) {
      open_ = entry.key;
      stopped_ = true;
      break;
    }
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    if (entry.id >= 0) {
      propagate(entry.id);
    } else if (VertexReach& reach = touch(~entry.id); reach.pending) {
      reach.pending = false;
      reach.fired = true;
      fire(~entry.id);
    }
  }
}

// ---------------------------------------------------------------- where paths start

template <class Real>
void Propagation<Real>::start(const EndPoint& source) {
  if (source.vertex >= 0) {
    VertexReach& reach = touch(source.vertex);
    reach.at_least = reach.at_most = 0;
    reach.all_around = reach.fired = true;
    if (target_ != nullptr && target_->vertex == source.vertex) reach_target(0, 0, -1, -1);
    if (target_ != nullptr && target_->vertex < 0) {
      for (const std::int32_t f : target_->faces)
        for (const std::int32_t v : mesh_->mesh().face(f))
          if (v == source.vertex) {
            const double straight = (source.position - target_->position).norm();
            reach_target(straight * (1 - 8 * kEpsilon) - target_->error, straight * (1 + 8 * kEpsilon) + target_->error,
                         -1, -1);
          }
    }
    fire(source.vertex);
    return;
  }
  for (const std::int32_t f : source.faces) start_in_face(source, f);
}

template <class Real>
void Propagation<Real>::start_in_face(const EndPoint& source, std::int32_t face) {
  const Eigen::Vector3d& p = source.position;
  if (target_ != nullptr && target_->vertex < 0 &&
      std::find(target_->faces.begin(), target_->faces.end(), face) != target_->faces.end()) {
    const double straight = (p - target_->position).norm(), off = source.error + target_->error;
    reach_target(straight * (1 - 8 * kEpsilon) - off, straight * (1 + 8 * kEpsilon) + off, -1, -1);
  }
  for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h) {
    const std::int32_t v = mesh_->tail(h);
    const Eigen::Vector3d from_tail = p - mesh_->position(v), from_head = p - mesh_->position(mesh_->head(h));
    const double straight = from_tail.norm();
    const Corner& corner = mesh_->corner(h);
    const Side<double>& s = mesh_->side(h);
    // The direction back to the source, in the fan of the corner.
    double direction = 0, slack = kInfinity;
    if (s.length > 0 && straight > 4 * source.error) {
      const Eigen::Vector3d edge = mesh_->position(mesh_->head(h)) - mesh_->position(v);
      const double angle = std::atan2(edge.cross(from_tail).norm(), edge.dot(from_tail));
      direction = corner.forward ? corner.begin + angle : corner.end - angle;
      slack = 2 * source.error / straight + 16 * kEpsilon + mesh_->turn_error(v);
    }
    reach(v, straight * (1 - 8 * kEpsilon) - source.error, straight * (1 + 8 * kEpsilon) + source.error, -1, -1,
          direction, slack);
    if (source.edge >= 0 && same_ends(*mesh_, h, source.edge)) continue;
    if (!(s.length > 0) || !(s.y > 0)) {
      block(bound_->from_vertex(v) - straight);
      continue;
    }
    const Eigen::Vector3d edge = mesh_->position(mesh_->head(h)) - mesh_->position(v);
    const bool near_tail = straight * straight < from_head.squaredNorm();
    Window<Real> w;
    w.end = Real(s.length);
    w.x = Real(edge.dot(from_tail) / s.length);
    w.height = Real(edge.cross(near_tail ? from_tail : from_head).norm() / s.length);
    w.error = 2 * source.error + 2 * kSideError * kEpsilon * straight;
    w.rise = w.error;
    add(h, true, w);
  }
}

/// The window of paths that leave a face through its side `from_side`, in coordinates that run from the side's tail or
/// from its head: counted as one of the face behind it.
template <class Real>
void Propagation<Real>::add(std::int32_t from_side, bool from_tail, Window<Real> w) {
  const std::int32_t behind = mesh_->across(from_side);
  if (behind == TriangleMesh::kBorder) return;
  const std::int32_t h = behind >= 0 ? behind : from_side;
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
  const double rest = bound_->through(h, value(w.begin), value(w.end), {value(w.x), value(w.height)});
  const double key = (w.sigma + rest) * (1 - 2 * kEpsilon) - w.error;
  if (key >= limit_) return;
  if (behind < 0) {
    fork_ = std::min(fork_, key);
    block(key);
    return;
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
  push(key, id);
}

/// What goes through a vertex that may be flat or a little more may turn there, by what its angle leaves open: as if
/// the image were off by that.
template <class Real>
void Propagation<Real>::turn_at_ends(std::int32_t h, Window<Real>& w) const {
  const std::int32_t tail = mesh_->tail(h), head = mesh_->head(h);
  const double x = value(w.x), height = value(w.height), length = mesh_->side(h).length;
  if (mesh_->kind(tail) == VertexKind::flat && !(value(w.begin) > 0))
    w.error += mesh_->turn_error(tail) * length_in_plane(x, height);
  if (mesh_->kind(head) == VertexKind::flat && !(value(w.end) < length))
    w.error += mesh_->turn_error(head) * length_in_plane(length - x, height);
}

// ---------------------------------------------------------------- over a face

/// Distances have come down since the window was made: is there a shorter way to all of its part (Xin and Wang 2009)?
template <class Real>
bool Propagation<Real>::dominated(const Window<Real>& w) const {
  if (w.root >= 0 && w.sigma > at_most(w.root)) return true;
  const double x = value(w.x), height = value(w.height), begin = value(w.begin), end = value(w.end);
  const double length = mesh_->side(w.halfedge).length;
  const double margin = w.error + 16 * kEpsilon * (w.sigma + length + length_in_plane(x, height));
  if (at_most(mesh_->tail(w.halfedge)) + end < w.sigma + length_in_plane(end - x, height) - margin) return true;
  return at_most(mesh_->head(w.halfedge)) + (length - begin) < w.sigma + length_in_plane(begin - x, height) - margin;
}

template <class Real>
void Propagation<Real>::propagate(std::int32_t id) {
  const Window<Real> w = pool_[at(id)];
  if (target_ == nullptr) free_.push_back(id);  // nobody asks for its path
  if (dominated(w)) return;
  const std::int32_t h = w.halfedge;
  const std::int32_t to_right = TriangleMesh::next(h), to_left = TriangleMesh::previous(h);
  const Side<Real> s = side(h);
  if (!(value(s.y) > 0)) {
    const double rest = bound_->through(h, value(w.begin), value(w.end), {value(w.x), value(w.height)});
    block((w.sigma + rest) * (1 - 2 * kEpsilon) - w.error);
    return;
  }
  if (target_ != nullptr && target_->vertex < 0) see_target(w, id);

  // Where the line from the image to the third corner crosses the edge, and how far rounding may have moved that.
  const double height = value(w.height), y = value(s.y);
  const Real crossing = w.x + (s.x - w.x) * w.height / (s.y + w.height);
  const double distance = length_in_plane(value(Real(s.x - w.x)), height + y);
  const double image_error = w.error + 2 * kSideError * kRoundingOf<Real> * distance;
  const double margin = 2 * image_error < height + y
                            ? 2 * image_error * distance * y / ((height + y) * (height + y)) +
                                  8 * kRoundingOf<Real> * (value(s.length) + std::abs(value(crossing)))
                            : kInfinity;
  const double after_begin = value(Real(crossing - w.begin)), before_end = value(Real(w.end - crossing));
  bool left = after_begin > -margin, right = before_end > -margin;
  if (left && right) {
    see_corner(w, id, distance, std::max({0.0, -after_begin, -before_end}));
    const double below = distance * height / (height + y);  // from the image to the crossing
    // The crossings are compared as doubles.
    const double room = height > 0 ? margin + 2 * w.spread * below * below / height +
                                         4 * kEpsilon * (value(s.length) + std::abs(value(crossing)))
                                   : kInfinity;
    if (after_begin > room && before_end > room) {
      Apex& apex = apex_[at(h)];
      const double least = w.sigma + distance - image_error - 8 * kEpsilon * (w.sigma + distance);
      const double most = w.sigma + distance + w.rise + image_error + 8 * kEpsilon * (w.sigma + distance);
      if (apex.query != query_ || most < apex.at_most) {
        apex = {query_, most, value(crossing), room};
      } else if (least > apex.at_most && std::abs(value(crossing) - apex.crossing) > room + apex.margin) {
        (value(crossing) < apex.crossing ? right : left) = false;
      }
    }
  }
  const std::int32_t a = mesh_->tail(h), b = mesh_->head(h), c = mesh_->tail(to_left);
  if (left) {
    const Real length = side(to_left).length;
    const Exit exit{to_left, a, c, b, length, s.x / length, s.y / length, s.length};
    leave(exit, w.begin, w.end, before_end > -margin, w, id);
  }
  if (right) {
    Window<Real> mirrored = w;
    mirrored.x = s.length - w.x;
    mirrored.error += 4 * kRoundingOf<Real> * (value(s.length) + std::abs(value(w.x)));
    const Real length = side(to_right).length;
    const Exit exit{to_right, b, c, a, length, s.back / length, s.y / length, s.length};
    leave(exit, s.length - w.end, s.length - w.begin, after_begin > -margin, mirrored, id);
  }
}

/// The part [b0, b1] of the edge entered, seen on through one exit. `to_far`: b1 goes beyond the third corner.
template <class Real>
void Propagation<Real>::leave(const Exit& exit, Real b0, Real b1, bool to_far, const Window<Real>& w, std::int32_t id) {
  const Real zero(0.0);
  Window<Real> next;
  next.parent = id;
  next.root = w.root;
  next.sigma = w.sigma;
  next.x = w.x * exit.ux - w.height * exit.uy;
  next.height = w.x * exit.uy + w.height * exit.ux;
  if (!(next.height > zero)) next.height = zero;  // paths cross from the near side: nearer to the truth
  const double image = length_in_plane(value(w.x), value(w.height));
  next.error = w.error + 2 * kSideError * kRoundingOf<Real> * image;

  const auto landing = [&](const Real& from) {
    const Real across = exit.ux * w.height - exit.uy * (from - w.x);
    return across > zero ? clamped(Real(w.height * from / across), zero, exit.length) : exit.length;
  };
  const double nx = value(next.x), nh = value(next.height);
  // How far the landing of a ray may be from where exact numbers would put it: the ray turns about its crossing of the
  // edge entered, by the image's error, and meets the exit at an angle whose sine is nh over the distance.
  const auto widening = [&](const Real& from, const Real& t, double& angle) {
    const double before = length_in_plane(value(Real(from - w.x)), value(w.height));
    const double all = length_in_plane(value(Real(t - next.x)), nh);
    if (!(2 * next.error * all < nh * before)) {
      angle = kInfinity;
      return kInfinity;
    }
    const double beyond = std::max(0.0, all - before) + 4 * kEpsilon * all;
    const double moved =
        (2 * next.error * beyond / before + 3 * kSideError * kRoundingOf<Real> * (all + std::abs(value(t)))) * all / nh;
    angle = moved * nh / (all * all);
    return moved;
  };
  double angle0 = 0, angle1 = 0, wider0 = 0, wider1 = 0;
  next.begin = landing(b0);
  if (next.begin > zero) wider0 = widening(b0, next.begin, angle0);
  next.end = exit.length;
  if (!to_far) {
    next.end = landing(b1);
    wider1 = widening(b1, next.end, angle1);
  }
  next.begin = value(next.begin) > wider0 ? Real(next.begin - Real(wider0)) : zero;
  next.end = value(Real(exit.length - next.end)) > wider1 ? Real(next.end + Real(wider1)) : exit.length;
  if (!(next.end > next.begin)) return;
  const double length = value(exit.length);
  next.rise = w.rise + 2 * std::min(length, std::max(wider0, wider1)) + 8 * kEpsilon * image;
  next.spread = w.spread + std::max(angle0, angle1);

  const double t0 = value(next.begin), t1 = value(next.end);
  const double r0 = w.sigma + length_in_plane(t0 - nx, nh), r1 = w.sigma + length_in_plane(t1 - nx, nh);
  const double margin = next.error + 16 * kEpsilon * (r0 + r1);
  if (at_most(exit.near) + t1 < r1 - margin) return;
  if (at_most(exit.far) + (length - t0) < r0 - margin) return;
  const double px = t0 * value(exit.ux) - value(exit.base), py = t0 * value(exit.uy);
  if (at_most(exit.opposite) + length_in_plane(px, py) < r0 - margin) return;

  add(exit.halfedge, mesh_->tail(exit.halfedge) == exit.near, next);
}

/// The third corner, seen through the part or up to `beside` (along the edge) past its end.
template <class Real>
void Propagation<Real>::see_corner(const Window<Real>& w, std::int32_t id, double distance, double beside) {
  const std::int32_t corner = TriangleMesh::previous(w.halfedge), v = mesh_->tail(corner);
  const double rounding = 8 * kEpsilon * (w.sigma + distance) + 2 * kSideError * kRoundingOf<Real> * distance;
  const double least = w.sigma + distance - w.error - rounding;
  const double most = w.sigma + distance + w.rise + w.error + 2 * beside + rounding;
  const VertexKind kind = mesh_->kind(v);
  double direction = 0, slack = kInfinity;
  if (least <= at_most(v) && (kind == VertexKind::saddle || kind == VertexKind::border) && distance > 8 * w.error) {
    const Side<double>& s = mesh_->side(w.halfedge);
    // From the corner: its half-edge leads to (0, 0), the image is at (x, -height).
    const double ax = -s.x, ay = -s.y, ix = value(w.x) - s.x, iy = -value(w.height) - s.y;
    const double angle = std::abs(std::atan2(ax * iy - ay * ix, ax * ix + ay * iy));
    const Corner& place = mesh_->corner(corner);
    direction = place.forward ? place.begin + angle : place.end - angle;
    slack = 2 * w.error / distance + w.spread + 2 * kSideError * kEpsilon + mesh_->turn_error(v);
  }
  reach(v, least, most, id, -1, direction, slack);
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
  const double distance = length_in_plane(tx - x, height + ty);
  const double crossing = height + ty > 0 ? x + (tx - x) * height / (height + ty) : x;
  const double depth = height + ty;
  const double margin = 2 * (w.error + place) < depth
                            ? 2 * (w.error + place) * (distance + place) / depth + 8 * kEpsilon * length
                            : kInfinity;
  const double beside = std::max({0.0, value(w.begin) - crossing, crossing - value(w.end)});
  if (beside > margin) return;
  const double rounding = 8 * kEpsilon * (w.sigma + distance) + place;
  reach_target(w.sigma + distance - w.error - rounding, w.sigma + distance + w.rise + w.error + 2 * beside + rounding,
               id, -1);
}

// ---------------------------------------------------------------- vertices

template <class Real>
void Propagation<Real>::reach_target(double at_least, double at_most, std::int32_t window, std::int32_t vertex) {
  target_at_least_ = std::min(target_at_least_, at_least);
  if (!(at_most < target_at_most_)) return;
  target_at_most_ = at_most;
  target_window_ = window;
  target_vertex_ = vertex;
  best_ = std::min(best_, at_most);
  limit_ = best_ * (1 - slack_);
}

template <class Real>
void Propagation<Real>::reach(std::int32_t v, double at_least, double at_most, std::int32_t window, std::int32_t vertex,
                              double direction, double slack) {
  VertexReach& reach = touch(v);
  if (at_least > reach.at_most) return;
  const bool better = at_most < reach.at_least, shorter = at_most < reach.at_most;
  if (shorter) {
    reach.from_window = window;
    reach.from_vertex = vertex;
  }
  if (target_ != nullptr && (target_->vertex < 0 || target_->vertex == v)) {
    if (target_->vertex == v) {
      reach_target(at_least, at_most, -1, v);
    } else {
      for (const std::int32_t f : target_->faces) {
        const auto& corners = mesh_->mesh().face(f);
        if (std::find(corners.begin(), corners.end(), v) == corners.end()) continue;
        const double straight = (mesh_->position(v) - target_->position).norm();
        reach_target(at_least + straight * (1 - 8 * kEpsilon) - target_->error,
                     at_most + straight * (1 + 8 * kEpsilon) + target_->error, -1, v);
        break;
      }
    }
  }
  const VertexKind kind = mesh_->kind(v);
  if (kind == VertexKind::convex || kind == VertexKind::flat) {
    reach.at_least = std::min(reach.at_least, at_least);
    reach.at_most = std::min(reach.at_most, at_most);
    return;
  }
  const double lowered = at_least - kCushion * at_most;
  const bool everywhere = kind == VertexKind::joint || !(slack < 1);
  const bool first = !(reach.at_most < kInfinity);
  if (first || better) {
    reach.at_least = lowered;
    reach.at_most = at_most;
    reach.direction = direction;
    reach.slack = slack + 100 * kCushion;
    reach.all_around = everywhere;
  } else {
    // As short as what is known, to rounding.
    reach.at_most = std::min(reach.at_most, at_most);
    const bool same = reach.all_around || std::abs(direction - reach.direction) + slack <= reach.slack;
    if (at_least >= reach.at_least && same) return;
    if (at_least < reach.at_least) reach.at_least = lowered;
    if (!same || everywhere) reach.all_around = true;
  }
  const double key = (reach.at_least + bound_->from_vertex(v)) * (1 - 2 * kEpsilon);
  if (key >= limit_) {
    reach.pending = false;
    return;
  }
  reach.pending = true;
  push(key, ~v);
}

/// Windows from a vertex that paths bend around: only where both sides of it are at least pi.
template <class Real>
void Propagation<Real>::fire(std::int32_t v) {
  const VertexReach reach = touch(v);
  const double full = mesh_->angle(v);
  for (const Corner& corner : mesh_->corners(v)) {
    if (reach.all_around) {
      fire_corner(v, corner, -kInfinity, kInfinity);
      continue;
    }
    const double from = reach.direction + std::numbers::pi - reach.slack;
    const double to = reach.direction - std::numbers::pi + reach.slack;
    if (mesh_->kind(v) == VertexKind::border) {
      fire_corner(v, corner, from, kInfinity);
      fire_corner(v, corner, -kInfinity, to);
    } else {
      fire_corner(v, corner, from, to + full);
      fire_corner(v, corner, from - full, to);
    }
  }
}

/// The part of the directions [from, to] that lies in one corner. All are paths: what the part is widened by costs no
/// length.
template <class Real>
void Propagation<Real>::fire_corner(std::int32_t v, const Corner& corner, double from, double to) {
  if (to < corner.begin || from > corner.end) return;
  const std::int32_t h = corner.halfedge, opposite = TriangleMesh::next(h);
  if (from <= corner.begin) fire_edge(v, corner.forward ? h : TriangleMesh::previous(h));
  if (to >= corner.end) fire_edge(v, corner.forward ? TriangleMesh::previous(h) : h);
  const VertexReach& reach = reach_[at(v)];
  const Side<Real> s = side(opposite);
  if (!(value(s.y) > 0) || !(value(s.length) > 0)) {
    block(reach.at_least + bound_->from_vertex(v));
    return;
  }
  Window<Real> w;
  w.root = v;
  w.sigma = reach.at_least;
  w.x = s.x;
  w.height = s.y;
  w.end = s.length;
  const double x = value(s.x), y = value(s.y), length = value(s.length);
  w.error = kSideError * kRoundingOf<Real> * std::min(length_in_plane(x, y), length + std::abs(x)) * 2;
  w.rise = reach.at_most - reach.at_least + w.error;
  // Angles from the side towards the tail of the opposite half-edge.
  const double low = std::max(0.0, from - corner.begin), high = std::min(corner.end, to) - corner.begin;
  const double all = corner.end - corner.begin;
  const double first = corner.forward ? low : all - high, last = corner.forward ? high : all - low;
  const double upright = std::atan2(x, y);  // the perpendicular, from the tail's side
  const auto landing = [&](double angle, double& wider) {
    const double off = upright - angle;
    const double t = std::abs(off) < 0.5 * std::numbers::pi ? x - y * std::tan(off) : off > 0 ? 0 : length;
    const double r = length_in_plane(t - x, y), turn = 16 * kEpsilon;
    wider = 4 * turn * r < y ? 2 * turn * r * r / y + 8 * kEpsilon * (length + std::abs(t)) : kInfinity;
    return t;
  };
  double wider = 0;
  if (first > 0) {
    const double t = landing(first, wider);
    w.begin = Real(std::clamp(t - wider, 0.0, length));
  }
  if (last < all) {
    const double t = landing(last, wider);
    w.end = t + wider < length ? Real(std::max(0.0, t + wider)) : s.length;
  }
  if (w.end > w.begin) add(opposite, true, w);
}

/// Along an edge from one end to the other.
template <class Real>
void Propagation<Real>::fire_edge(std::int32_t v, std::int32_t halfedge) {
  const bool out = mesh_->tail(halfedge) == v;
  const std::int32_t to = out ? mesh_->head(halfedge) : mesh_->tail(halfedge);
  const VertexReach& from = reach_[at(v)];
  const double length = mesh_->side(halfedge).length;
  // The corner of the other end in the same face, and on which of its sides the edge is.
  const Corner& corner = mesh_->corner(out ? TriangleMesh::next(halfedge) : halfedge);
  const double direction = out != corner.forward ? corner.begin : corner.end;
  reach(to, from.at_least + length * (1 - 8 * kEpsilon), from.at_most + length * (1 + 8 * kEpsilon), -1, v, direction,
        mesh_->turn_error(to));
}

// ---------------------------------------------------------------- the path

template <class Real>
void Propagation<Real>::trace_back(std::int32_t window, Point2 towards, SurfacePath& reversed) const {
  while (window >= 0) {
    const Window<Real>& w = pool_[at(window)];
    const std::int32_t h = w.halfedge, g = mesh_->across(h);
    const double length = mesh_->side(h).length, x = value(w.x), height = value(w.height);
    const double depth = height + towards.y;
    const double at_edge =
        std::clamp(depth > 0 ? x + (towards.x - x) * height / depth : x, value(w.begin), value(w.end));
    const Eigen::Vector3d &a = mesh_->position(mesh_->tail(h)), &b = mesh_->position(mesh_->head(h));
    reversed.faces.push_back(h / 3);
    const double share = at_edge / length;
    reversed.points.push_back(share < 0.5 ? Eigen::Vector3d(a + share * (b - a))
                                          : Eigen::Vector3d(b + (1 - share) * (a - b)));
    if (w.parent >= 0) {
      // The same point in the frame of the edge before, one of whose face's other sides g is.
      const std::int32_t entered = pool_[at(w.parent)].halfedge;
      const Side<double>& s = mesh_->side(entered);
      const bool on_left = g == TriangleMesh::previous(entered);
      const std::int32_t near = on_left ? mesh_->tail(entered) : mesh_->head(entered);
      const double t = mesh_->tail(h) == near ? at_edge : length - at_edge;
      towards = on_left ? Point2{t * s.x / length, t * s.y / length}
                        : Point2{s.length - t * s.back / length, t * s.y / length};
    } else {
      reversed.faces.push_back(g / 3);  // from the root to the first crossing
    }
    window = w.parent;
  }
}

template <class Real>
SurfacePath Propagation<Real>::path() const {
  SurfacePath back;
  if (target_ == nullptr || !(target_at_most_ < kInfinity)) return back;
  back.points.push_back(target_->position);
  const TriangleMesh& mesh = mesh_->mesh();
  const auto has = [&mesh](std::int32_t f, std::int32_t v) {
    const auto& c = mesh.face(f);
    return c[0] == v || c[1] == v || c[2] == v;
  };
  const auto common = [&](std::int32_t v, std::int32_t other, const EndPoint& end) {
    if (other >= 0) {
      for (const std::int32_t f : mesh.faces_of_vertex(v))
        if (has(f, other)) return f;
    }
    for (const std::int32_t f : end.faces)
      if (has(f, v)) return f;
    return mesh.faces_of_vertex(v).front();
  };
  std::int32_t vertex = target_vertex_, window = target_window_;
  if (window >= 0) {
    const std::int32_t h = pool_[at(window)].halfedge;
    const Eigen::Vector3d a = mesh_->position(mesh_->tail(h)), edge = mesh_->position(mesh_->head(h)) - a;
    const Eigen::Vector3d from_a = target_->position - a;
    const double length = mesh_->side(h).length;
    trace_back(window, {edge.dot(from_a) / length, edge.cross(from_a).norm() / length}, back);
  } else if (vertex >= 0 && vertex != target_->vertex) {
    back.faces.push_back(common(vertex, -1, *target_));
    back.points.push_back(mesh_->position(vertex));
  } else if (vertex < 0) {  // straight from the source
    std::int32_t face = -1;
    if (source_->vertex >= 0) face = common(source_->vertex, target_->vertex, *target_);
    for (const std::int32_t f : source_->faces)
      if (std::find(target_->faces.begin(), target_->faces.end(), f) != target_->faces.end()) face = f;
    if (source_->vertex >= 0 && source_->vertex == target_->vertex) return back;
    back.faces.push_back(face);
    back.points.push_back(source_->position);
    return reversed(back);
  }
  if (window >= 0)
    vertex = [&] {
      std::int32_t id = window;
      while (pool_[at(id)].parent >= 0) id = pool_[at(id)].parent;
      return pool_[at(id)].root;
    }();
  if (window >= 0) back.points.push_back(vertex >= 0 ? mesh_->position(vertex) : source_->position);
  // From vertex to vertex back to the source.
  while (vertex >= 0 && vertex != source_->vertex) {
    const VertexReach& reach = reached(vertex);
    std::int32_t before = reach.from_vertex;
    if (reach.from_window >= 0) {
      const std::int32_t h = pool_[at(reach.from_window)].halfedge;
      const Side<double>& s = mesh_->side(h);
      trace_back(reach.from_window, {s.x, s.y}, back);
      std::int32_t id = reach.from_window;
      while (pool_[at(id)].parent >= 0) id = pool_[at(id)].parent;
      before = pool_[at(id)].root;
    } else {
      back.faces.push_back(before >= 0 ? common(vertex, before, *source_) : common(vertex, -1, *source_));
    }
    back.points.push_back(before >= 0 ? mesh_->position(before) : source_->position);
    vertex = before;
  }
  return reversed(back);
}

template class Propagation<double>;
template class Propagation<DoubleDouble>;

}  // namespace leastcost
