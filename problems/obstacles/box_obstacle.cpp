// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/box_obstacle.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <leastcost/framework/errors.hpp>
#include "framework/point_text.hpp"

namespace leastcost {
namespace {

class BoxObstacle final : public Obstacle {
 public:
  explicit BoxObstacle(const BoxObstacleOptions& options) : lower_(options.lower), upper_(options.upper) {}

  std::string name() const override { return "the box from " + point_text(lower_) + " to " + point_text(upper_); }
  Box core_bounds() const override { return {lower_, upper_}; }
  double radius() const override { return 0; }
  bool convex() const override { return true; }
  Eigen::MatrixXd corners() const override {
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

  /// The square of the distance is convex in t and a parabola between the places where the segment meets the planes of
  /// the sides: its slope is followed from one to the next, to where it changes its sign.
  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    std::vector<double> bends;
    bends.reserve(static_cast<std::size_t>(2 * a.size() + 2));
    bends.push_back(0);
    bends.push_back(1);
    for (Eigen::Index i = 0; i < a.size(); ++i)
      for (const double side : {lower_[i], upper_[i]}) {
        const double bend = (side - a[i]) / (b[i] - a[i]);
        if (bend > 0 && bend < 1) bends.push_back(bend);
      }
    std::sort(bends.begin(), bends.end());
    const auto slope = [&](double at) {
      double sum = 0;
      for (Eigen::Index i = 0; i < a.size(); ++i) sum += outside(a, b, at, i) * (b[i] - a[i]);
      return sum;
    };
    t = 1;
    double left = slope(0);
    if (left >= 0) t = 0;
    for (std::size_t k = 1; t == 1 && k < bends.size(); ++k) {
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

 private:
  /// How far a place on the way from a to b is off the box, along one axis.
  double outside(const Vector& a, const Vector& b, double t, Eigen::Index i) const {
    const double x = a[i] + t * (b[i] - a[i]);
    return x - std::min(std::max(x, lower_[i]), upper_[i]);
  }

  Vector lower_, upper_;
};

}  // namespace

void BoxObstacleOptions::fields(FieldVisitor& visit) {
  visit.field("lower", lower, {.help = "Corner with the least coordinates.", .unit = "length", .required = true});
  visit.field("upper", upper, {.help = "Corner with the largest coordinates.", .unit = "length", .required = true});
}

std::shared_ptr<const Obstacle> make_box_obstacle(const BoxObstacleOptions& options) {
  if (options.lower.size() == 0 || !options.lower.allFinite())
    throw OptionError("lower", "must be a point, with finite coordinates");
  if (options.upper.size() != options.lower.size() || !options.upper.allFinite())
    throw OptionError("upper", "must have as many coordinates as lower (" + std::to_string(options.lower.size()) +
                                   "), all of them finite");
  if (!(options.lower.array() <= options.upper.array()).all())
    throw OptionError("upper", "must be at least lower in every coordinate");
  return std::make_shared<BoxObstacle>(options);
}

}  // namespace leastcost
