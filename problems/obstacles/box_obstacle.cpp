// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/box_obstacle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/obstacles/segment_tree.hpp"

namespace leastcost {
namespace {

/// Two triangles on each of the six sides.
std::vector<SegmentTree::Triangle> sides_of(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  std::vector<SegmentTree::Triangle> all;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool low : {true, false}) {
      const Eigen::Vector3d &corner = low ? lower : upper, &other = low ? upper : lower;
      Eigen::Vector3d beside = corner, across = corner, opposite = corner;
      beside[u] = opposite[u] = other[u];
      across[v] = opposite[v] = other[v];
      all.push_back({corner, beside, opposite});
      all.push_back({corner, opposite, across});
    }
  }
  return all;
}

class BoxObstacle final : public Obstacle, public MeetsTriangles, public HasCoreBox {
 public:
  BoxObstacle(const BoxObstacleOptions& corners, std::string name, bool drawn)
      : name_(std::move(name)), drawn_(drawn), lower_(corners.lower), upper_(corners.upper) {
    if (lower_.size() == 3) sides_.emplace(sides_of(lower_, upper_));
  }

  std::string name() const override { return name_; }
  bool drawn() const override { return drawn_; }
  Box core_bounds() const override { return {lower_, upper_}; }
  double radius() const override { return 0; }
  bool convex() const override { return true; }
  Eigen::MatrixXd corners() const override {
    if (lower_.size() == 3) {
      Eigen::MatrixXd all(3, 8);
      for (Eigen::Index k = 0; k < 8; ++k)
        for (Eigen::Index i = 0; i < 3; ++i) all(i, k) = ((k >> i) & 1) != 0 ? upper_[i] : lower_[i];
      return all;
    }
    Eigen::MatrixXd all(2, 4);
    all << lower_[0], upper_[0], upper_[0], lower_[0], lower_[1], lower_[1], upper_[1], upper_[1];
    return all;
  }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    away = x - x.cwiseMax(lower_).cwiseMin(upper_);
    const double distance = away.norm();
    if (distance > 0) {
      away /= distance;
      return distance;
    }
    Eigen::Index below = 0, above = 0;  // the side that is nearest from within
    const double to_lower = (x - lower_).minCoeff(&below), to_upper = (upper_ - x).minCoeff(&above);
    away = to_lower < to_upper ? Vector(-Vector::Unit(x.size(), below)) : Vector(Vector::Unit(x.size(), above));
    return -std::min(to_lower, to_upper);
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    if (a.size() > 3) {
      std::vector<double> bends(static_cast<std::size_t>(2 * a.size() + 2));
      return least_along(a, b, bends, t);
    }
    std::array<double, 8> bends;
    return least_along(a, b, bends, t);
  }

  double distance_of_triangle(const std::array<Eigen::Vector3d, 3>& corners, Eigen::Vector3d& nearest) const override {
    nearest = corners[0];
    if ((nearest.array() >= lower_.array()).all() && (nearest.array() <= upper_.array()).all()) return 0;
    return sides_->distance(corners, nearest);
  }

  OrientedBox core_box() const override {
    OrientedBox box;
    box.center.head(lower_.size()) = (lower_ + upper_) / 2;
    box.half.head(lower_.size()) = (upper_ - lower_) / 2;
    return box;
  }

 private:
  bool has_core_box() const override { return lower_.size() <= 3; }
  bool measures_triangles() const override { return sides_.has_value(); }

  /// The square of the distance is convex in t and a parabola between the places where the segment meets the planes of
  /// the sides: its slope is followed from one to the next, to where it changes its sign.
  double least_along(const Vector& a, const Vector& b, std::span<double> bends, double& t) const {
    std::size_t count = 0;
    bends[count++] = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i)
      for (const double side : {lower_[i], upper_[i]})
        if ((a[i] < side && side < b[i]) || (b[i] < side && side < a[i]))
          bends[count++] = std::min(1.0, (side - a[i]) / (b[i] - a[i]));
    bends[count++] = 1;
    std::sort(bends.begin(), bends.begin() + static_cast<std::ptrdiff_t>(count));
    const auto slope = [&](double at) {
      double sum = 0;
      for (Eigen::Index i = 0; i < a.size(); ++i) sum += outside(a, b, at, i) * (b[i] - a[i]);
      return sum;
    };
    t = 1;
    double left = slope(0);
    if (left >= 0) t = 0;
    for (std::size_t k = 1; t == 1 && k < count; ++k) {
      const double right = slope(bends[k]);
      if (right >= 0) {
        const double share = right > left ? -left / (right - left) : 0;
        t = bends[k - 1] + share * (bends[k] - bends[k - 1]);
        break;
      }
      left = right;
    }
    double square = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i) square += outside(a, b, t, i) * outside(a, b, t, i);
    return std::sqrt(square);
  }

  /// How far a place on the way from a to b is off the box, along one axis.
  double outside(const Vector& a, const Vector& b, double t, Eigen::Index i) const {
    const double x = a[i] + t * (b[i] - a[i]);
    return x - std::min(std::max(x, lower_[i]), upper_[i]);
  }

  std::string name_;
  bool drawn_;
  Vector lower_, upper_;
  std::optional<SegmentTree> sides_ = {};  ///< in space
};

}  // namespace

std::shared_ptr<const Obstacle> make_box_obstacle(const BoxObstacleOptions& options, const BoxLook& look) {
  if (options.lower.size() == 0 || !options.lower.allFinite())
    throw OptionError("lower", "must be a point, with finite coordinates");
  if (options.upper.size() != options.lower.size() || !options.upper.allFinite())
    throw OptionError("upper", "must have as many coordinates as lower (" + std::to_string(options.lower.size()) +
                                   "), all of them finite");
  if (!(options.lower.array() <= options.upper.array()).all())
    throw OptionError("upper", "must not be below lower in any coordinate");
  std::string name = look.name;
  if (look.with_place) name += " from " + point_text(options.lower) + " to " + point_text(options.upper);
  return std::make_shared<BoxObstacle>(options, std::move(name), look.drawn);
}

}  // namespace leastcost
