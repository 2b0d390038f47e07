// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/exact/propagation_parts.hpp"

namespace leastcost {
using exact::kEpsilon, exact::kInfinity, exact::length_in_plane, exact::value;
namespace {

/// Values are held apart by this much, relative, so that two roundings of one distance are one distance.
constexpr double kCushion = 1e-13;

}  // namespace

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
void Propagation<Real>::reach(std::int32_t v, const Found& found, std::int32_t window, std::int32_t vertex,
                              double direction, double slack) {
  const double at_least = std::max(found.at_least, found.before), at_most = found.at_most;
  VertexReach& reach = touch(v);
  if (at_least > reach.at_most) return;
  reach.about = std::min(reach.about, found.about);
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
    guide(v).at_most = reach.at_most = std::min(reach.at_most, at_most);
    return;
  }
  // Else two vertices at one place would lower each other again and again.
  const double lowered = std::max(at_least - kCushion * at_most, found.before);
  const bool everywhere = kind == VertexKind::joint || !(slack < 1);
  const bool first = !(reach.at_most < kInfinity);
  if (first || better) {
    reach.at_least = lowered;
    guide(v).at_most = reach.at_most = at_most;
    reach.direction = direction;
    reach.slack = slack + 100 * kCushion;
    reach.all_around = everywhere;
  } else {
    // As short as what is known, to rounding.
    guide(v).at_most = reach.at_most = std::min(reach.at_most, at_most);
    const bool same = reach.all_around || std::abs(direction - reach.direction) + slack <= reach.slack;
    if (at_least >= reach.at_least && same) return;
    if (at_least < reach.at_least) reach.at_least = lowered;
    if (!same || everywhere) reach.all_around = true;
  }
  const double key = (reach.at_least + rest(v)) * (1 - 2 * kEpsilon);
  if (key >= limit_) {
    reach.pending = false;
    return;
  }
  reach.pending = true;
  queue_.push(by_distance_ ? std::min(reach.at_least, key) : key, key, ~v);
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
    // Where it has no inside, all that goes on from here goes along its edges.
    if (mesh_->is_needle(opposite / 3)) return;
    block(reach.at_least + rest(v));
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
  reach(to,
        {from.at_least + length * (1 - 8 * kEpsilon), from.at_most + length * (1 + 8 * kEpsilon), from.about + length,
         from.at_least},
        -1, v, direction, mesh_->turn_error(to));
}

template void Propagation<double>::reach_target(double, double, std::int32_t, std::int32_t);
template void Propagation<double>::reach(std::int32_t, const Found&, std::int32_t, std::int32_t, double, double);
template void Propagation<double>::fire(std::int32_t);
template void Propagation<DoubleDouble>::reach_target(double, double, std::int32_t, std::int32_t);
template void Propagation<DoubleDouble>::reach(std::int32_t, const Found&, std::int32_t, std::int32_t, double, double);
template void Propagation<DoubleDouble>::fire(std::int32_t);

}  // namespace leastcost
