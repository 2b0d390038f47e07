// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "problems/exact/propagation.hpp"
#include "problems/exact/propagation_parts.hpp"

/// A vertex between coplanar faces divides every window that comes to it, and behind it the two parts have the same
/// image again, side by side. Where both wait over the same edge they are joined, so that flat parts of a surface take
/// as few windows as if they had no vertices.
namespace leastcost {
using exact::value;
namespace {

constexpr double kSameImage = 64;  // images no farther apart than this are one
/// A part that rays graze raises what is known of all that it is joined with. Without a target, where distances are
/// delivered from both sides, no more than this, relative.
constexpr double kLoose = 1e-10;

}  // namespace

/// With the window that waits over the edge of h already, if both are parts of one: that one waits no longer.
template <class Real>
bool Propagation<Real>::join(std::int32_t h, const Real& length, Window<Real>& w) {
  const std::int32_t waiting = edge(h).waiting;
  if (waiting < 0) return false;
  Window<Real>& other = pool_[at(waiting)];
  if (other.halfedge != h || other.root != w.root || other.sigma != w.sigma) return false;
  if (other.begin > w.end || w.begin > other.end || is_sliver(other, length)) return false;
  const double apart = std::abs(value(Real(other.x - w.x))) + std::abs(value(Real(other.height - w.height)));
  if (apart > kSameImage * kRoundingOf<Real> * (std::abs(value(w.x)) + value(w.height) + value(length))) return false;
  const double rise = std::max(w.rise, other.rise) + apart;
  if (!bound_->aims() && rise > kLoose * (w.sigma + std::abs(value(w.x)) + value(w.height))) return false;

  if (keeps_) {
    const std::int32_t others = other.parts >= 0 ? other.parts : keep_part(other, -1);
    w.parts = keep_part(w, others);
  }
  // By the image that may be off by more: the other one is as near to that, or hardly farther.
  if (w.error < other.error) {
    std::swap(w.x, other.x);
    std::swap(w.height, other.height);
    std::swap(w.error, other.error);
  }
  w.error = std::max(w.error, other.error + apart);
  w.turned = std::max(w.turned, other.turned);
  w.rise = rise;
  w.spread = std::max(w.spread, other.spread);
  w.begin = std::min(w.begin, other.begin);
  w.end = std::max(w.end, other.end);
  other.halfedge = -1;
  return true;
}

/// Remembers where one part of a window came from, before the parts from `next` on.
template <class Real>
std::int32_t Propagation<Real>::keep_part(const Window<Real>& w, std::int32_t next) {
  parts_.push_back({value(w.begin), value(w.end), w.parent, next});
  return static_cast<std::int32_t>(parts_.size()) - 1;
}

/// The window from which paths come to this place of a taken one.
template <class Real>
std::int32_t Propagation<Real>::parent_at(const Taken& w, double place) const {
  std::int32_t parent = w.parent;
  double least = exact::kInfinity;
  for (std::int32_t i = w.parts; i >= 0; i = parts_[at(i)].next) {
    const Part& part = parts_[at(i)];
    const double off = std::max({0.0, part.begin - place, place - part.end});
    if (off < least) {
      least = off;
      parent = part.parent;
    }
  }
  return parent;
}

template bool Propagation<double>::join(std::int32_t, const double&, Window<double>&);
template std::int32_t Propagation<double>::parent_at(const Taken&, double) const;
template bool Propagation<DoubleDouble>::join(std::int32_t, const DoubleDouble&, Window<DoubleDouble>&);
template std::int32_t Propagation<DoubleDouble>::parent_at(const Taken&, double) const;

}  // namespace leastcost
