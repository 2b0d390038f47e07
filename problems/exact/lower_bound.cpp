// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/lower_bound.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leastcost {
namespace {

constexpr double kDown = 1 - 32 * kRoundingOf<double>;  // more than the roundings of the sums and roots below

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// A target beyond the edge that is as far from its ends as these numbers. Squares of distances are a parabola along
/// the edge with 1 as its leading coefficient, so that its distances are nowhere above the linear interpolation.
void place_target(double at_tail, double at_head, double length, EdgeState& edge) {
  edge.target_x = 0.5 * ((at_tail - at_head) * (at_tail + at_head) / length + length);
  edge.target_y = std::sqrt(std::max(0.0, at_tail * at_tail - edge.target_x * edge.target_x));
  const double above_tail = length_of(edge.target_x, edge.target_y) - at_tail;
  const double above_head = length_of(length - edge.target_x, edge.target_y) - at_head;
  edge.rounding += std::max({0.0, above_tail, above_head});
}

/// Distance from a landmark to an end that need not be a vertex, from both sides.
std::pair<double, double> field_at(const HalfEdges& mesh, const Landmarks& landmarks, std::int32_t i,
                                   const EndPoint& end) {
  if (end.vertex >= 0) return {landmarks.at_least(end.vertex, i), landmarks.at_most(end.vertex, i)};
  double low = 0, high = std::numeric_limits<double>::infinity();
  for (const std::int32_t v : mesh.mesh().face(end.faces.front())) {
    const double off = (mesh.position(v) - end.position).norm() / kDown + end.error;
    low = std::max(low, landmarks.at_least(v, i) - off);
    high = std::min(high, landmarks.at_most(v, i) + off);
  }
  return {low, high};
}

}  // namespace

LowerBound::LowerBound(const HalfEdges& mesh, const EndPoint* target, const Landmarks* landmarks, FrontBound* fronts)
    : mesh_(&mesh), aims_(target != nullptr), fronts_(fronts) {
  if (!aims_) return;
  target_ = target->position;
  target_error_ = target->error;
  if (landmarks == nullptr) return;
  landmarks_ = landmarks;
  for (std::int32_t i = 0; i < landmarks->count(); ++i) {
    const auto [low, high] = field_at(mesh, *landmarks, i, *target);
    const bool reached = std::isfinite(high);
    beyond_.push_back(reached ? high / kDown : std::numeric_limits<double>::infinity());
    before_.push_back(reached ? low * kDown - landmarks->width(i) : -std::numeric_limits<double>::infinity());
  }
}

double LowerBound::from_vertex(std::int32_t v) const {
  if (!aims_) return 0;
  double best = (mesh_->position(v) - target_).norm() * kDown - target_error_;
  if (fronts_ != nullptr) best = std::max(best, fronts_->from_vertex(v));
  if (landmarks_ != nullptr) {
    const std::span<const float> fields = landmarks_->at_least(v);
    double farther = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const double field = static_cast<double>(fields[i]);
      farther = std::max(farther, std::max(field - beyond_[i], before_[i] - field));
    }
    // Infinite: not in the component of a landmark; the search finds that out by itself.
    if (std::isfinite(farther)) best = std::max(best, farther * kDown);
  }
  return std::max(0.0, best);
}

double LowerBound::from_end(const EndPoint& end) const {
  if (!aims_) return 0;
  if (end.vertex >= 0) return from_vertex(end.vertex);
  double best = (end.position - target_).norm() * kDown - target_error_ - end.error;
  for (const std::int32_t v : mesh_->mesh().face(end.faces.front()))
    best = std::max(best, (from_vertex(v) - (mesh_->position(v) - end.position).norm() / kDown - end.error) * kDown);
  return std::max(0.0, best);
}

void LowerBound::look_from(std::int32_t h, EdgeState& edge) const {
  const Eigen::Vector3d &a = mesh_->position(mesh_->tail(h)), &b = mesh_->position(mesh_->head(h));
  const Eigen::Vector3d along = b - a, from_a = target_ - a, from_b = target_ - b;
  const double length = mesh_->side(h).length, away_a = from_a.squaredNorm(), away_b = from_b.squaredNorm();
  edge.target_x = along.dot(from_a) / length;
  edge.target_y = along.cross(away_a < away_b ? from_a : from_b).norm() / length;
  // Rounding of the target's place in the plane of the edge is relative to its distance.
  const double scale = std::max({edge.rest_tail, edge.rest_head, std::sqrt(std::max(away_a, away_b))});
  edge.rounding = (1 - kDown) * (scale + length) + target_error_;
  if (fronts_ == nullptr || !(length > 0)) return;
  const auto at_ends = fronts_->along(h);
  if (at_ends && std::min(at_ends->first, at_ends->second) > 0 &&
      at_ends->first + at_ends->second > std::sqrt(away_a) + std::sqrt(away_b))
    place_target(at_ends->first, at_ends->second, length, edge);
}

double LowerBound::through(const EdgeState& edge, double length, double begin, double end,
                           const ImagePlace& image) const {
  const double nearest = std::clamp(image.x, begin, end);
  if (!aims_) return length_of(nearest - image.x, image.height) * kDown;
  // The straight line between image and target, both in the plane of the edge and on its two sides.
  const double depth = image.height + edge.target_y, aside = (edge.target_x - image.x) * image.height;
  const bool before = aside<(begin - image.x) * depth, beyond = aside>(end - image.x) * depth;
  double best = 0;
  if (!before && !beyond) {
    best = length_of(edge.target_x - image.x, depth);
  } else {
    const double x = before ? begin : end;
    best = length_of(x - image.x, image.height) + length_of(x - edge.target_x, edge.target_y);
  }
  // A distance climbs at most by one per length: on the edge it is above the V of its values at the ends.
  const double kink = std::clamp(0.5 * (edge.rest_tail - edge.rest_head + length), begin, end);
  const double rest = std::max(edge.rest_tail - kink, edge.rest_head - length + kink);
  best = std::max(best, length_of(kink - image.x, image.height) + rest);
  return best * kDown - edge.rounding;
}

}  // namespace leastcost
