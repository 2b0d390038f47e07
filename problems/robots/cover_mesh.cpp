// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/cover_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/symmetric_eigen.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

double volume_of(const Covering& covering) {
  double all = 0;
  for (const Capsule& one : covering.capsules)
    all += std::numbers::pi * one.radius * one.radius * ((one.to - one.from).norm() + 4.0 / 3 * one.radius);
  return all;
}

/// The principal axis along which the points reach farthest.
Vector3d longest_axis(const std::vector<Vector3d>& points) {
  Vector3d center = Vector3d::Zero();
  for (const Vector3d& point : points) center += point / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points) spread += (point - center) * (point - center).transpose();
  const Eigen::MatrixXd axes = symmetric_eigen(spread).vectors;
  Vector3d best = Vector3d::UnitX();
  double longest = -1;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3d axis = axes.col(k);
    double low = 0, high = 0;
    for (const Vector3d& point : points) {
      low = std::min(low, axis.dot(point - center));
      high = std::max(high, axis.dot(point - center));
    }
    if (high - low <= longest) continue;
    longest = high - low;
    best = axis;
  }
  return best;
}

/// The mesh, cut across an axis.
class Slabs {
 public:
  Slabs(const std::vector<Vector3d>& points, const std::vector<std::array<std::int32_t, 3>>& faces)
      : points_(points), faces_(faces), axis_(longest_axis(points)) {
    for (const Vector3d& point : points_) along_.push_back(axis_.dot(point));
    const auto [low, high] = std::minmax_element(along_.begin(), along_.end());
    low_ = *low;
    high_ = *high;
  }

  Covering covered(int count) const {
    std::vector<std::vector<Vector3d>> parts(static_cast<std::size_t>(count));
    const auto cut = [&](int k) { return low_ + (high_ - low_) * k / count; };
    const auto slab = [&](double along) {
      return std::clamp(static_cast<int>(count * (along - low_) / (high_ - low_)), 0, count - 1);
    };
    for (std::size_t i = 0; i < points_.size(); ++i)
      parts[static_cast<std::size_t>(slab(along_[i]))].push_back(points_[i]);
    // Where edges cross the cuts. Rounding moves these by less than what cover_points() adds to its radius for it.
    for (const auto& face : faces_) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        auto a = static_cast<std::size_t>(face[corner]), b = static_cast<std::size_t>(face[(corner + 1) % 3]);
        if (along_[a] > along_[b]) std::swap(a, b);
        for (int k = slab(along_[a]); k <= slab(along_[b]) + 1; ++k) {
          if (k < 1 || k >= count || cut(k) < along_[a] || cut(k) > along_[b]) continue;
          const double width = along_[b] - along_[a], t = width > 0 ? (cut(k) - along_[a]) / width : 0;
          const Vector3d place = points_[a] + t * (points_[b] - points_[a]);
          parts[static_cast<std::size_t>(k - 1)].push_back(place);
          parts[static_cast<std::size_t>(k)].push_back(place);
        }
      }
    }
    Covering out;
    for (const std::vector<Vector3d>& part : parts) {
      if (part.empty()) continue;  // of a mesh in several pieces
      const Covering one = cover_points(part);
      out.capsules.insert(out.capsules.end(), one.capsules.begin(), one.capsules.end());
    }
    return out;
  }

  bool thick() const { return high_ > low_; }

 private:
  const std::vector<Vector3d>& points_;
  const std::vector<std::array<std::int32_t, 3>>& faces_;
  Vector3d axis_;
  std::vector<double> along_;  ///< of the points, on the axis
  double low_ = 0, high_ = 0;
};

}  // namespace

Covering cover_mesh(const std::vector<Vector3d>& points, const std::vector<std::array<std::int32_t, 3>>& faces) {
  constexpr double kWorth = 0.8;
  Covering best = cover_points(points);
  for (const auto& face : faces)
    for (const std::int32_t corner : face)
      if (corner < 0 || static_cast<std::size_t>(corner) >= points.size())
        throw OptionError("faces", "must have corners that are numbers of points");
  const Slabs slabs(points, faces);
  for (const int count : {2, 4, 8}) {
    if (!slabs.thick()) break;
    Covering finer = slabs.covered(count);
    finer.adds = reach_beyond(finer.capsules, points);
    if (finer.adds < kWorth * best.adds || volume_of(finer) < kWorth * volume_of(best)) best = std::move(finer);
  }
  return best;
}

}  // namespace leastcost
