// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/propagation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "problems/exact/propagation_parts.hpp"

namespace leastcost {
using exact::kEpsilon, exact::kInfinity;
namespace {

constexpr std::int64_t kLook = 256;   // windows between two looks at the clock
constexpr double kSlotsPerEdge = 16;  // of the queue, towards a target: mean edge length over width
constexpr double kSlotsPerEdgeToAll = 2;
constexpr double kFirstSlots = 2048;  // and of the distance between the ends
constexpr double kUsualWindows = 4;   // of a query, per face: most take fewer

bool same_ends(const HalfEdges& mesh, std::int32_t h, std::int32_t g) {
  return (mesh.tail(h) == mesh.tail(g) && mesh.head(h) == mesh.head(g)) ||
         (mesh.tail(h) == mesh.head(g) && mesh.head(h) == mesh.tail(g));
}

}  // namespace

template <class Real>
Propagation<Real>::Propagation(const HalfEdges& mesh)
    : mesh_(&mesh),
      forks_(mesh),
      reach_(at(mesh.mesh().vertex_count())),
      guides_(at(mesh.mesh().vertex_count())),
      slots_(3 * static_cast<std::size_t>(mesh.mesh().face_count())) {}

template <class Real>
VertexReach& Propagation<Real>::touch(std::int32_t v) {
  VertexReach& reach = reach_[at(v)];
  if (reach.query != query_) reach = VertexReach{.query = query_};
  return reach;
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

/// Asked before every step. What holds windows may grow to twice of what it holds, and while it does, the old and the
/// new one are there.
template <class Real>
bool Propagation<Real>::is_spent(const QueryLimits& limits, std::int64_t step) {
  constexpr double kWaiting = 2 * (sizeof(Window<Real>) + sizeof(WindowQueue::Entry)), kTaken = 2 * sizeof(Taken),
                   kParts = 2 * sizeof(Part), kSlivers = 2 * sizeof(Sliver<Real>);
  out_of_memory_ = kWaiting * static_cast<double>(pool_.size()) + kTaken * static_cast<double>(taken_.size()) +
                       kParts * static_cast<double>(parts_.size()) + kSlivers * static_cast<double>(slivers_.size()) >
                   limits.max_memory;
  if (out_of_memory_ || windows_ > limits.max_windows) return true;
  if (step % kLook != 0) return false;
  if (limits.watch) limits.watch(queue_.floor(), windows_);
  return limits.stop && limits.stop();
}

template <class Real>
void Propagation<Real>::run(std::span<const EndPoint> sources, const EndPoint* target, const LowerBound& bound,
                            const QueryLimits& limits) {
  ++query_;
  pool_.clear();
  free_.clear();
  taken_.clear();
  edges_.clear();
  slivers_.clear();
  parts_.clear();
  source_ = &sources.front();
  target_ = target;
  bound_ = &bound;
  best_ = limits.upper;
  slack_ = limits.slack;
  limit_ = best_ * (1 - slack_);
  target_at_least_ = target_at_most_ = blocked_ = crowded_ = kInfinity;
  target_window_ = target_vertex_ = -1;
  open_ = 0;
  stopped_ = out_of_memory_ = false;
  keeps_ = target != nullptr || limits.keep_windows;
  // Room that is not written costs nothing, and growing would write each page twice.
  if (keeps_)
    taken_.reserve(static_cast<std::size_t>(
        std::min(kUsualWindows * mesh_->mesh().face_count(), limits.max_memory / (2 * sizeof(Taken)))));
  sabotage_ = limits.sabotage;
  sabotaged_ = sabotage_.drop_every > 0 || sabotage_.crack > 0;
  windows_ = 0;

  const double straight = bound.from_end(*source_), edge = mesh_->mean_edge();
  by_distance_ = limits.by_distance;
  const double slot = bound.aims() ? std::max(edge / kSlotsPerEdge, straight / kFirstSlots) : edge / kSlotsPerEdgeToAll;
  queue_.begin(by_distance_ ? 0 : straight, slot > 0 ? slot : 1);
  for (const EndPoint& source : sources) start(source);
  std::int64_t steps = 0;
  while (queue_.settle()) {
    if (queue_.floor() >= limit_) break;
    if (is_spent(limits, ++steps)) {
      open_ = by_distance_ ? queue_.least_key() : queue_.floor();
      stopped_ = true;
      break;
    }
    const WindowQueue::Entry entry = queue_.pop();
    if (entry.key >= limit_) continue;
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
    reach.at_least = reach.at_most = reach.about = guide(source.vertex).at_most = 0;
    reach.all_around = reach.fired = true;
    reach.pending = false;  // another source may have reached it
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
    reach(v, {straight * (1 - 8 * kEpsilon) - source.error, straight * (1 + 8 * kEpsilon) + source.error, straight, 0},
          -1, -1, direction, slack);
    if (source.edge >= 0 && same_ends(*mesh_, h, source.edge)) continue;
    const bool beside_vertex = std::min(straight, from_head.norm()) <= 4 * source.error;
    if (mesh_->is_needle(face) && !(s.length > 0 && beside_vertex)) {
      // The source is on both long sides, and paths start into the faces behind them. What lies behind the short side,
      // whose ends are at one place, is reached along edges.
      if (s.length > 0 && leads_out(h)) {
        Window<Real> w;
        w.end = Real(s.length);
        w.x = Real((mesh_->position(mesh_->head(h)) - mesh_->position(v)).dot(from_tail) / s.length);
        w.error = 2 * source.error + 2 * kSideError * kEpsilon * straight;
        w.rise = w.error;
        add(h, true, w);
      }
      continue;
    }
    if (!(s.length > 0) || !(s.y > 0)) {
      block(rest(v) - straight);
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

template Propagation<double>::Propagation(const HalfEdges&);
template void Propagation<double>::run(std::span<const EndPoint>, const EndPoint*, const LowerBound&,
                                       const QueryLimits&);
template double Propagation<double>::lower_bound() const;
template void Propagation<double>::block(double);
template VertexReach& Propagation<double>::touch(std::int32_t);
template Propagation<DoubleDouble>::Propagation(const HalfEdges&);
template void Propagation<DoubleDouble>::run(std::span<const EndPoint>, const EndPoint*, const LowerBound&,
                                             const QueryLimits&);
template double Propagation<DoubleDouble>::lower_bound() const;
template void Propagation<DoubleDouble>::block(double);
template VertexReach& Propagation<DoubleDouble>::touch(std::int32_t);

}  // namespace leastcost
