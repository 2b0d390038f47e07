// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/length_search.hpp>

#include <algorithm>
#include <cmath>
#include <span>

#include "problems/mesh/edge_landmarks.hpp"
#include "problems/mesh/edge_search.hpp"

namespace leastcost {
namespace {

using Vector = Eigen::Vector3d;

/// Floats of two lengths are off by half of this, relative to the longer.
constexpr float kFloatRounding = 4 * std::numeric_limits<float>::epsilon();

/// The length in one constant metric.
class LengthCost {
 public:
  static constexpr int kLookEvery = 256;

  LengthCost(const TriangleMesh& mesh, const LengthSearchOptions& options) : mesh_(&mesh), options_(&options) {}

  double operator()(const Vector& a, const Vector& b) const { return std::sqrt(squared(a, b)); }
  /// By squares, before any root.
  bool may_be_below(const Vector& a, const Vector& b, double limit) const { return squared(a, b) < limit * limit; }

  DiagonalMove across(const Vector& from, const Vector& tail, const Vector& head, const Vector& to) const {
    Vector e = head - tail, a = from - tail, b = to - tail;
    if (options_->metric) {
      const Eigen::Matrix3d& root = *options_->metric;
      e = Vector(root * e);
      a = Vector(root * a);
      b = Vector(root * b);
    }
    const auto crossing = unfolded_crossing(e, a, b);
    if (!crossing) return {};
    const auto& [at, squared, along, depth] = *crossing;
    return {std::sqrt((along * along + depth * depth) / squared), at};
  }

  /// The landmarks' distances to the target: one in another component says nothing, and infinite values only get in the
  /// way.
  void aim(const Vector& goal, std::span<const std::int32_t> vertices) {
    goal_ = goal;
    aims_ = true;
    if (options_->landmarks == nullptr) return;
    const EdgeLandmarks& landmarks = *options_->landmarks;
    target_fields_.assign(static_cast<std::size_t>(landmarks.count()), std::numeric_limits<float>::infinity());
    for (const std::int32_t v : vertices) {
      const double further = (*this)(mesh_->position(v), goal_);
      const std::span<const float> fields = landmarks.of(v);
      for (std::size_t i = 0; i < fields.size(); ++i)
        target_fields_[i] = std::min(target_fields_[i], static_cast<float>(static_cast<double>(fields[i]) + further));
    }
    if (!std::all_of(target_fields_.begin(), target_fields_.end(), [](float f) { return std::isfinite(f); }))
      target_fields_.clear();
  }

  /// The straight line, and what the landmarks leave open.
  double rest(std::int32_t node, const Vector& x) const {
    if (!aims_) return 0;
    const double straight = (*this)(x, goal_);
    if (target_fields_.empty() || node >= mesh_->vertex_count()) return straight;
    float best = 0;
    const std::span<const float> fields = options_->landmarks->of(node);
    for (std::size_t i = 0; i < fields.size(); ++i)
      best = std::max(
          best, std::abs(fields[i] - target_fields_[i]) - kFloatRounding * std::max(fields[i], target_fields_[i]));
    return std::max(straight, static_cast<double>(best));
  }

 private:
  double squared(const Vector& a, const Vector& b) const {
    if (options_->metric) [[unlikely]]
      return (*options_->metric * (b - a)).squaredNorm();
    return (b - a).squaredNorm();
  }

  const TriangleMesh* mesh_;
  const LengthSearchOptions* options_;
  Vector goal_ = Vector::Zero();
  std::vector<float> target_fields_;  // of the landmarks, at the target
  bool aims_ = false;
};

}  // namespace

struct LengthSearch::State {
  const TriangleMesh* mesh;
  EdgeSearch<LengthCost> search;
};

LengthSearch::LengthSearch(const TriangleMesh& mesh)
    : state_(std::make_unique<State>(State{&mesh, EdgeSearch<LengthCost>(mesh)})) {}
LengthSearch::~LengthSearch() = default;
LengthSearch::LengthSearch(LengthSearch&&) noexcept = default;
LengthSearch& LengthSearch::operator=(LengthSearch&&) noexcept = default;

EdgePath LengthSearch::shortest(const SurfacePoint& source, const SurfacePoint& target,
                                const LengthSearchOptions& options) {
  return state_->search.shortest(source, target, {*state_->mesh, options}, options.diagonals, options.stop);
}

std::vector<double> LengthSearch::lengths_from(std::int32_t vertex, const LengthSearchOptions& options) {
  return state_->search.costs_from(vertex, {*state_->mesh, options}, options.stop);
}

}  // namespace leastcost
