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
constexpr std::size_t kUsed = 8;                        // landmarks per query: more cost more than they prune

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

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

LowerBound::LowerBound(const HalfEdges& mesh, const EndPoint& source, const EndPoint* target,
                       const Landmarks* landmarks)
    : mesh_(&mesh), aims_(target != nullptr) {
  if (!aims_) return;
  target_ = target->position;
  target_error_ = target->error;
  if (landmarks == nullptr) return;
  landmarks_ = landmarks;
  std::vector<std::pair<double, std::int32_t>> worth;
  for (std::int32_t i = 0; i < landmarks->count(); ++i) {
    const auto [s_low, s_high] = field_at(mesh, *landmarks, i, source);
    const auto [t_low, t_high] = field_at(mesh, *landmarks, i, *target);
    const double says = std::max(s_low - t_high, t_low - s_high);
    if (std::isfinite(t_high) && says > 0) worth.emplace_back(-says, i);
  }
  std::sort(worth.begin(), worth.end());
  if (worth.size() > kUsed) worth.resize(kUsed);
  for (const auto& [unused, i] : worth) {
    const auto [low, high] = field_at(mesh, *landmarks, i, *target);
    used_.push_back(i);
    at_least_.push_back(low);
    at_most_.push_back(high);
  }
}

double LowerBound::from_vertex(std::int32_t v) const {
  if (!aims_) return 0;
  double best = (mesh_->position(v) - target_).norm() * kDown - target_error_;
  for (std::size_t k = 0; k < used_.size(); ++k) {
    best = std::max(best, landmarks_->at_least(v, used_[k]) - at_most_[k]);
    best = std::max(best, at_least_[k] - landmarks_->at_most(v, used_[k]));
  }
  return std::max(0.0, best);
}

double LowerBound::through(std::int32_t h, double begin, double end, const ImagePlace& image) const {
  const double nearest = std::clamp(image.x, begin, end);
  if (!aims_) return length_of(nearest - image.x, image.height) * kDown;
  // The target turned into the plane of the image, beyond the edge: the straight line between them is the bound.
  const std::int32_t a = mesh_->tail(h), b = mesh_->head(h);
  const Eigen::Vector3d from_a = target_ - mesh_->position(a);
  const double length = mesh_->side(h).length;
  const Eigen::Vector3d edge = mesh_->position(b) - mesh_->position(a), from_b = target_ - mesh_->position(b);
  const double tx = edge.dot(from_a) / length;
  const double ty = edge.cross(from_a.squaredNorm() < from_b.squaredNorm() ? from_a : from_b).norm() / length;
  const double depth = image.height + ty;
  const double x = std::clamp(depth > 0 ? image.x + (tx - image.x) * image.height / depth : nearest, begin, end);
  double best = length_of(x - image.x, image.height) + length_of(x - tx, ty);
  // A field of distances climbs at most by one per length: on the edge it is above the V of its values at the ends.
  for (std::size_t k = 0; k < used_.size(); ++k) {
    const std::int32_t i = used_[k];
    for (const bool towards : {false, true}) {
      const double f = towards ? landmarks_->at_least(a, i) - at_most_[k] : at_least_[k] - landmarks_->at_most(a, i);
      const double g = towards ? landmarks_->at_least(b, i) - at_most_[k] : at_least_[k] - landmarks_->at_most(b, i);
      if (std::max(f, g) <= 0) continue;
      const double kink = std::clamp(0.5 * (f - g + length), begin, end);
      const double rest = std::max(f - kink, g - length + kink);
      best = std::max(best, length_of(kink - image.x, image.height) + rest);
    }
  }
  // Rounding of the target's place in the plane of the edge is relative to its distance.
  const double place = (1 - kDown) * std::max(from_a.norm(), from_b.norm());
  return best * kDown - place - target_error_;
}

}  // namespace leastcost
