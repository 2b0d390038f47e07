// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/front_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

/// Fronts are a 25th of the way apart, but no fewer edges than this. Closer ones lose more along their own edges, wider
/// ones more in the chords between them.
constexpr double kFronts = 50;
constexpr std::int32_t kLeastStep = 4;
constexpr double kWorth = 4;    // steps of a way that is worth fronts
constexpr double kPiece = 0.3;  // of the mean edge of a front: edges are divided to have no longer pieces
/// Relative rounding of a bound in floats: three coordinates, their differences, a root, two sums, twice over.
constexpr double kFloats = 32 * 0x1p-24;
/// Of lengths whose squares floats hold, with 1e-7 of them.
constexpr double kShort = 1e-15, kLong = 1e15;

}  // namespace

FrontBound::FrontBound(const HalfEdges& mesh) : mesh_(&mesh) {}

bool FrontBound::is_worth(const HalfEdges& mesh, double length) {
  return length >= kWorth * kLeastStep * mesh.mean_edge();
}

void FrontBound::aim(const EndPoint& source, const EndPoint& target, double upper, const FromVertex& to_source,
                     const std::function<bool()>& stop) {
  ++query_;
  count_ = 0;
  source_ = source.position;
  target_ = target.position;
  target_error_ = target.error;
  upper_ = upper;
  extent_ = (upper + 2 * (source.error + target.error)) * (1 + 64 * kRoundingOf<double>);
  const double farthest = extent_ + 2 * mesh_->longest_edge();
  rounding_ = kFloats * farthest;
  if (!is_worth(*mesh_, upper) || extent_ < kShort || farthest > kLong) return;
  const double vertices = mesh_->mesh().vertex_count();
  step_ = std::max(kLeastStep, static_cast<std::int32_t>(std::min(upper / (kFronts * mesh_->mean_edge()), vertices)));
  vertices_.resize(static_cast<std::size_t>(vertices));
  start(target);
  for (std::int32_t level = 0; begin_of(level) < met_.size(); ++level) {
    if (stop && stop()) {
      count_ = 0;
      return;
    }
    level_end_.push_back(met_.size());
    if (level > 0 && level % step_ == 0) make_front(level, to_source);
    spread(level);
  }
}

/// The corners around the target, at level 0.
void FrontBound::start(const EndPoint& target) {
  met_.clear();
  level_end_.clear();
  const auto meet = [&](std::int32_t v) {
    if (has_seen(v)) return;
    vertices_[static_cast<std::size_t>(v)] = {.query = query_};
    met_.push_back(v);
  };
  if (target.vertex >= 0) meet(target.vertex);
  for (const std::int32_t f : target.faces)
    for (const std::int32_t v : mesh_->mesh().face(f)) meet(v);
}

/// To the vertices of the next level that paths which count may come by.
void FrontBound::spread(std::int32_t level) {
  const std::size_t end = end_of(level);
  for (std::size_t i = begin_of(level); i < end; ++i) {
    if (!is_met(met_[i])) continue;
    for (const std::int32_t v : mesh_->mesh().neighbours(met_[i])) {
      const Eigen::Vector3d& p = mesh_->position(v);
      if (has_seen(v) || is_apart(v, (p - source_).norm() + (p - target_).norm())) continue;
      vertices_[static_cast<std::size_t>(v)] = {.query = query_, .level = level + 1};
      met_.push_back(v);
    }
  }
}

/// Whether no path that counts comes into a face at v, when paths from one end over v to the other are no shorter than
/// this. Places of these faces are no farther from v than its longest edge.
bool FrontBound::is_apart(std::int32_t v, double sum) const {
  if (sum <= extent_ || sum > extent_ + 2 * mesh_->longest_edge()) return sum > extent_;
  double longest = 0;
  for (const std::int32_t to : mesh_->mesh().neighbours(v))
    longest = std::max(longest, (mesh_->position(to) - mesh_->position(v)).squaredNorm());
  return sum > extent_ + 2 * std::sqrt(longest);
}

/// Edges to vertices of the same level with larger numbers, beside a face that has a vertex of the level before: where
/// paths come in. Twice where there are two such faces.
template <class Visit>
void FrontBound::each_edge(std::int32_t v, const Visit& visit) const {
  const std::int32_t level = this->level(v);
  const auto look = [&](std::int32_t to, std::int32_t third, std::int32_t side) {
    if (v < to && is_met(to) && is_met(third) && this->level(to) == level && this->level(third) == level - 1)
      visit(to, mesh_->side(side).length);
  };
  for (const Corner& corner : mesh_->corners(v)) {
    const std::int32_t h = corner.halfedge, back = TriangleMesh::previous(h);
    const std::int32_t a = mesh_->head(h), b = mesh_->tail(back);
    look(a, b, h);
    look(b, a, back);
  }
}

/// Of the vertices of this level; those that turn out to be too far from the ends are taken away.
void FrontBound::make_front(std::int32_t level, const FromVertex& to_source) {
  if (static_cast<std::size_t>(count_) == fronts_.size()) fronts_.emplace_back();
  Front& front = fronts_[static_cast<std::size_t>(count_)];
  const std::size_t begin = begin_of(level), end = end_of(level);
  at_front_.clear();
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Vector3d& p = mesh_->position(met_[i]);
    at_front_.push_back(before() != nullptr ? before()->through(p - target_) : straight(p));
    if (is_apart(met_[i], at_front_.back().bound - rounding_ + to_source(met_[i])))
      vertices_[static_cast<std::size_t>(met_[i])].level = kApart;
  }
  double all = 0;
  int edges = 0;
  for (std::size_t i = begin; i < end; ++i)
    each_edge(met_[i], [&](std::int32_t, double length) {
      all += length;
      ++edges;
    });
  front.begin(edges > 0 ? kPiece * all / edges : 0);
  // Each vertex with its edges, so that points which follow each other are close to each other.
  for (std::size_t i = begin; i < end; ++i) {
    if (!is_met(met_[i])) continue;
    add_point(front, mesh_->position(met_[i]), at_front_[i - begin]);
    add_edges(front, met_[i], at_front_[i - begin]);
  }
  // No path that counts comes through.
  if (front.empty()) front.add(Eigen::Vector3d::Zero(), upper_);
  front.finish();
  ++count_;
}

/// The points between the ends of the edges of v.
void FrontBound::add_edges(Front& front, std::int32_t v, const Front::Least& least) {
  const Eigen::Vector3d& a = mesh_->position(v);
  double longest = 0;
  each_edge(v, [&](std::int32_t, double length) { longest = std::max(longest, length); });
  if (!(longest > front.piece())) return;
  if (before() != nullptr) before()->gather(a - target_, least, longest, near_);
  each_edge(v, [&](std::int32_t to, double length) {
    const int pieces = static_cast<int>(std::ceil(length / front.piece()));
    const Eigen::Vector3d along = mesh_->position(to) - a;
    for (int k = 1; k < pieces; ++k) {
      const Eigen::Vector3d place = a + along * (static_cast<double>(k) / pieces);
      add_point(front, place, before() != nullptr ? before()->through(place - target_, near_) : straight(place));
    }
  });
}

/// A point of the front that is made now, if a path that counts may cross a piece beside it.
void FrontBound::add_point(Front& front, const Eigen::Vector3d& position, const Front::Least& least) const {
  const double bound = least.bound - rounding_;
  if (bound + (position - source_).norm() > upper_ + 2 * front.piece()) return;
  front.add(position - target_, bound - sag(least.gap, front.piece()));
}

/// To the target, where no front lies between.
Front::Least FrontBound::straight(const Eigen::Vector3d& position) const {
  const double distance = (position - target_).norm();
  return {distance - target_error_, distance};
}

/// By the last front at least half a step nearer to the target: beside a front, the sag is large.
const FrontBound::Vertex* FrontBound::asked(std::int32_t v) {
  Vertex& vertex = vertices_[static_cast<std::size_t>(v)];
  if (!is_met(v)) return nullptr;
  if (vertex.bound < 0) {
    vertex.front = std::min((vertex.level - step_ / 2) / step_, count_) - 1;
    vertex.bound = 0;
    if (vertex.front >= 0) {
      Front& front = fronts_[static_cast<std::size_t>(vertex.front)];
      const Front::Least least = front.through(mesh_->position(v) - target_);
      vertex.bound = static_cast<float>(std::max(0.0, least.bound - rounding_));
      vertex.gap = static_cast<float>(least.gap);
    }
  }
  return &vertex;
}

double FrontBound::from_vertex(std::int32_t v) {
  if (!helps()) return 0;
  const Vertex* const vertex = asked(v);
  return vertex == nullptr ? upper_ : std::max(0.0, static_cast<double>(vertex->bound) - rounding_);
}

std::optional<std::pair<double, double>> FrontBound::along(std::int32_t h) {
  if (!helps()) return std::nullopt;
  const Vertex *const tail = asked(mesh_->tail(h)), *const head = asked(mesh_->head(h));
  if (tail == nullptr || head == nullptr || tail->front != head->front || tail->front < 0) return std::nullopt;
  if (!(std::min(tail->bound, head->bound) > 0)) return std::nullopt;  // they may be less in truth
  const double gap = static_cast<double>(std::min(tail->gap, head->gap)), length = mesh_->side(h).length;
  const double piece = fronts_[static_cast<std::size_t>(tail->front)].piece();
  const double off = sag(gap - piece, length) + sag(gap - length, piece) + rounding_;
  return std::pair(static_cast<double>(tail->bound) - off, static_cast<double>(head->bound) - off);
}

}  // namespace leastcost
