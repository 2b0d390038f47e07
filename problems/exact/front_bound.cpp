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
constexpr double kFronts = 25;
constexpr std::int32_t kLeastStep = 6;
constexpr double kWorth = 4;    // steps of a way that is worth fronts
constexpr double kPiece = 0.5;  // of the mean edge of a front: edges are divided to have no longer pieces
constexpr int kLanes = 16;      // numbers at a time
/// Relative rounding of a bound in floats: three coordinates, their differences, a root, two sums, twice over.
constexpr double kFloats = 32 * 0x1p-24;
/// Of lengths whose squares floats hold, with 1e-7 of them.
constexpr double kShort = 1e-15, kLong = 1e15;

using Lanes = Eigen::Array<float, kLanes, 1>;

Eigen::Map<const Lanes> lanes(const std::vector<float>& numbers, std::size_t first) {
  return Eigen::Map<const Lanes>(numbers.data() + first);
}

/// By how much the better end of a piece may exceed the least value on it, of the distance from a point that is as far
/// as `gap` from the ends of pieces: a convex function, whose second derivative is 1 over the distance at most, and
/// whose slope is 1 at most.
double sag(double gap, double piece) {
  const double distance = gap - piece;
  return distance > 0 ? std::min(piece, piece * piece / (8 * distance)) : piece;
}

}  // namespace

void FrontBound::Front::clear() {
  for (std::vector<float>* numbers : {&x, &y, &z, &bound}) numbers->clear();
  piece = 0;
}

void FrontBound::Front::add(const Eigen::Vector3d& place, double at_least) {
  x.push_back(static_cast<float>(place.x()));
  y.push_back(static_cast<float>(place.y()));
  z.push_back(static_cast<float>(place.z()));
  bound.push_back(static_cast<float>(at_least));
}

/// With copies of the last point, to a multiple of the lanes.
void FrontBound::Front::fill_up() {
  const std::size_t full = (x.size() + kLanes - 1) / kLanes * kLanes;
  for (std::vector<float>* numbers : {&x, &y, &z, &bound}) numbers->resize(full, numbers->back());
}

FrontBound::FrontBound(const HalfEdges& mesh) : mesh_(&mesh) {}

bool FrontBound::is_worth(const HalfEdges& mesh, double length) {
  return length >= kWorth * kLeastStep * mesh.mean_edge();
}

void FrontBound::aim(const EndPoint& source, const EndPoint& target, double upper, const std::function<bool()>& stop) {
  ++query_;
  count_ = 0;
  source_ = source.position;
  target_ = target.position;
  target_error_ = target.error;
  upper_ = upper;
  // The corners of a face that such a path crosses are no farther from it than the longest edge.
  extent_ = (upper + 2 * (mesh_->longest_edge() + source.error + target.error)) * (1 + 64 * kRoundingOf<double>);
  rounding_ = kFloats * extent_;
  if (!is_worth(*mesh_, upper) || extent_ < kShort || extent_ > kLong) return;
  const double vertices = mesh_->mesh().vertex_count();
  step_ = std::max(kLeastStep, static_cast<std::int32_t>(std::min(upper / (kFronts * mesh_->mean_edge()), vertices)));
  vertices_.resize(static_cast<std::size_t>(vertices));
  if (!spread(target, stop)) return;
  const std::int32_t levels = static_cast<std::int32_t>(level_end_.size());
  for (std::int32_t level = step_; level < levels && !(stop && stop()); level += step_) make_front(level);
}

/// Levels of the vertices that paths which count may come by; false where it was stopped, and some may be missing.
bool FrontBound::spread(const EndPoint& target, const std::function<bool()>& stop) {
  met_.clear();
  level_end_.clear();
  const auto meet = [&](std::int32_t v, std::int32_t level) {
    vertices_[static_cast<std::size_t>(v)] = {.query = query_, .level = level};
    met_.push_back(v);
  };
  if (target.vertex >= 0) meet(target.vertex, 0);
  for (const std::int32_t f : target.faces)
    for (const std::int32_t v : mesh_->mesh().face(f))
      if (!is_met(v)) meet(v, 0);
  for (std::size_t next = 0; next < met_.size();) {
    if (stop && stop()) return false;
    level_end_.push_back(met_.size());
    for (const std::size_t end = met_.size(); next < end; ++next)
      for (const std::int32_t v : mesh_->mesh().neighbours(met_[next])) {
        if (is_met(v)) continue;
        const Eigen::Vector3d& p = mesh_->position(v);
        if ((p - source_).norm() + (p - target_).norm() <= extent_)
          meet(v, static_cast<std::int32_t>(level_end_.size()));
      }
  }
  return true;
}

/// Edges between vertices of this level, beside a face that has a vertex of the level before: where paths come in. From
/// the end with the smaller number; twice where there are two such faces.
template <class Visit>
void FrontBound::each_edge(std::int32_t level, const Visit& visit) const {
  const std::size_t begin = level_end_[static_cast<std::size_t>(level) - 1];
  const std::size_t end = level_end_[static_cast<std::size_t>(level)];
  const auto look = [&](std::int32_t v, std::int32_t to, std::int32_t third, std::int32_t side) {
    if (v < to && is_met(to) && is_met(third) && this->level(to) == level && this->level(third) == level - 1)
      visit(v, to, mesh_->side(side).length);
  };
  for (std::size_t i = begin; i < end; ++i)
    for (const Corner& corner : mesh_->corners(met_[i])) {
      const std::int32_t h = corner.halfedge, back = TriangleMesh::previous(h);
      const std::int32_t v = met_[i], a = mesh_->head(h), b = mesh_->tail(back);
      look(v, a, b, h);
      look(v, b, a, back);
    }
}

void FrontBound::make_front(std::int32_t level) {
  if (static_cast<std::size_t>(count_) == fronts_.size()) fronts_.emplace_back();
  Front& front = fronts_[static_cast<std::size_t>(count_)];
  front.clear();
  double all = 0;
  int edges = 0;
  each_edge(level, [&](std::int32_t, std::int32_t, double length) {
    all += length;
    ++edges;
  });
  front.piece = edges > 0 ? kPiece * all / edges : 0;
  const std::size_t begin = level_end_[static_cast<std::size_t>(level) - 1];
  for (std::size_t i = begin; i < level_end_[static_cast<std::size_t>(level)]; ++i)
    add_point(front, mesh_->position(met_[i]));
  each_edge(level, [&](std::int32_t v, std::int32_t to, double length) {
    const int pieces = static_cast<int>(std::ceil(length / front.piece));
    const Eigen::Vector3d &a = mesh_->position(v), &b = mesh_->position(to);
    for (int k = 1; k < pieces; ++k) add_point(front, a + (b - a) * (static_cast<double>(k) / pieces));
  });
  // No path that counts comes through.
  if (front.x.empty()) front.add(Eigen::Vector3d::Zero(), upper_);
  front.fill_up();
  ++count_;
}

/// A point of the front that is made now, if a path that counts may cross a piece beside it.
void FrontBound::add_point(Front& front, const Eigen::Vector3d& position) const {
  const Least least = at_place(count_ - 1, position);
  if (least.bound + (position - source_).norm() > upper_ + 2 * front.piece) return;
  front.add(position - target_, least.bound - sag(least.gap, front.piece));
}

/// At a position outside the front with this number; -1: of the straight line to the target.
FrontBound::Least FrontBound::at_place(std::int32_t front, const Eigen::Vector3d& position) const {
  const Eigen::Vector3d place = position - target_;
  if (front >= 0) return through(fronts_[static_cast<std::size_t>(front)], place);
  const double straight = place.norm();
  return {straight - target_error_ - rounding_, straight};
}

FrontBound::Least FrontBound::through(const Front& front, const Eigen::Vector3d& place) const {
  const Eigen::Vector3f p = place.cast<float>();
  Lanes best = Lanes::Constant(std::numeric_limits<float>::infinity()), nearest = best;
  for (std::size_t i = 0; i < front.x.size(); i += kLanes) {
    const Lanes squared = (lanes(front.x, i) - p.x()).square() + (lanes(front.y, i) - p.y()).square() +
                          (lanes(front.z, i) - p.z()).square();
    best = best.min(lanes(front.bound, i) + squared.sqrt());
    nearest = nearest.min(squared);
  }
  const double gap = std::sqrt(static_cast<double>(nearest.minCoeff()));
  return {static_cast<double>(best.minCoeff()) - sag(gap, front.piece) - rounding_, gap};
}

/// By the last front at least half a step nearer to the target: beside a front, the sag is large.
const FrontBound::Vertex* FrontBound::asked(std::int32_t v) {
  Vertex& vertex = vertices_[static_cast<std::size_t>(v)];
  if (vertex.query != query_) return nullptr;
  if (vertex.bound < 0) {
    vertex.front = std::min((vertex.level - step_ / 2) / step_, count_) - 1;
    vertex.bound = 0;
    if (vertex.front >= 0) {
      const Least least = through(fronts_[static_cast<std::size_t>(vertex.front)], mesh_->position(v) - target_);
      vertex.bound = static_cast<float>(std::max(0.0, least.bound));
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
  const double piece = fronts_[static_cast<std::size_t>(tail->front)].piece;
  const double off = sag(gap - piece, length) + sag(gap - length, piece) + rounding_;
  return std::pair(static_cast<double>(tail->bound) - off, static_cast<double>(head->bound) - off);
}

}  // namespace leastcost
