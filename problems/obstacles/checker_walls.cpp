// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/checker_walls.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/obstacles/least_along.hpp"

namespace leastcost {
namespace {

using Vector = Walls::Vector;

constexpr double kTolerance = 1e-4, kTightTolerance = 1e-9;  ///< sizes
constexpr double kShareOfRoom = 0.2;                         ///< that need not be found
constexpr double kDifference = 1e-6;                         ///< sizes: half the step of central differences
constexpr double kOfValues = 16 * std::numeric_limits<double>::epsilon();

void require_number(const char* key, double value, bool positive) {
  if (std::isfinite(value) && (positive ? value > 0 : value >= 0)) return;
  throw OptionError(key, positive ? "must be a number greater than 0" : "must be a number, at least 0");
}

/// Distances are divided by their Lipschitz constant: the quotient is nowhere more than the true distance.
class DistanceWalls final : public Walls {
 public:
  DistanceWalls(Eigen::Index dimension, DistanceChecker checker) : dimension_(dimension), checker_(std::move(checker)) {
    if (!checker_.distance) throw OptionError("distance", "a checker needs a function");
    require_number("lipschitz", checker_.lipschitz, true);
    require_number("curvature", checker_.curvature, false);
    require_number("clearance", checker_.clearance, false);
    require_number("depth", checker_.depth, false);
    require_number("size", checker_.size, true);
    if (checker_.curvature > 0 && !(checker_.curvature_from < checker_.clearance))
      throw OptionError("curvature_from", "must be less than the clearance");
    tolerance_ = checker_.tolerance.value_or((checker_.curvature > 0 ? kTightTolerance : kTolerance) * checker_.size);
    require_number("tolerance", tolerance_, true);
    known_ = {1, checker_.curvature / checker_.lipschitz,
              checker_.curvature_from / checker_.lipschitz - checker_.clearance};
  }

  Eigen::Index dimension() const override { return dimension_; }
  double size() const override { return checker_.size; }
  std::string obstacle_name(int obstacle) const override { return obstacle < 0 ? "" : checker_.name; }

  void near(const Vector& x, double reach, std::vector<Wall>& found) const override {
    found.clear();
    const double gap = distance(x) - kept();
    if (gap >= reach) return;
    // Where nothing is known there is no way out either.
    found.push_back(std::isnan(gap) ? Wall{0, -size(), Vector::Zero(x.size())} : Wall{0, gap, slope(x), required()});
  }

  MoveClearance clearance(const Vector& a, const Vector& b) const override {
    const LeastValue least = along_line(a, b);
    const double length = (b - a).norm(), rounding = kOfValues * std::max(size(), a.cwiseAbs().maxCoeff());
    return {least.lower - rounding, least.upper, 0, length > 0 ? Vector(a + least.at / length * (b - a)) : a};
  }

  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override {
    found.clear();
    const LeastValue least = along_line(a, b);
    const double gap = least.upper - tolerance_, length = (b - a).norm();
    if (!(gap < reach)) return;
    const double at = length > 0 ? least.at / length : 0;
    found.push_back({0, gap, slope(a + at * (b - a)), required(), at});
  }

  double room(const Vector& a, const Vector& b, double reach) const override {
    const double to_core = checker_.clearance + checker_.depth / checker_.lipschitz;
    if (!(to_core > 0)) return reach;
    const double lower = to_core + along_line(a, b, {kShareOfRoom * to_core, 0, reach - to_core, false}).lower;
    return std::isnan(lower) ? 0 : std::clamp(lower, 0.0, reach);
  }

 private:
  /// Beyond what must not be passed through; infinite where that is not watched.
  double required() const {
    const double to_core = checker_.clearance + checker_.depth / checker_.lipschitz;
    return to_core > 0 ? to_core + tolerance_ : std::numeric_limits<double>::infinity();
  }
  double kept() const { return checker_.clearance + tolerance_; }
  double distance(const Vector& x) const { return checker_.distance(x) / checker_.lipschitz; }

  Vector slope(const Vector& x) const {
    if (checker_.gradient) return checker_.gradient(x) / checker_.lipschitz;
    const double step = kDifference * size();
    Vector slope(x.size()), moved = x;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      moved[i] = x[i] + step;
      const double ahead = distance(moved);
      moved[i] = x[i] - step;
      slope[i] = (ahead - distance(moved)) / (2 * step);
      moved[i] = x[i];
    }
    return slope.allFinite() ? slope : Vector(Vector::Zero(x.size()));
  }

  /// Of the distance minus the clearance.
  LeastValue along_line(const Vector& a, const Vector& b, const LeastPrecision& precision) const {
    const double length = (b - a).norm();
    const auto gap = [&](double s) {
      return distance(length > 0 ? Vector(a + s / length * (b - a)) : a) - checker_.clearance;
    };
    return least_along(gap, length, known_, precision);
  }
  LeastValue along_line(const Vector& a, const Vector& b) const { return along_line(a, b, {tolerance_ / 2}); }

  Eigen::Index dimension_;
  DistanceChecker checker_;
  double tolerance_ = 0;
  LineBounds known_;  ///< of the distance minus the clearance
};

class FreeWalls final : public Walls {
 public:
  FreeWalls(Eigen::Index dimension, FreeChecker checker) : dimension_(dimension), checker_(std::move(checker)) {
    if (!checker_.is_free) throw OptionError("is_free", "a checker needs a function");
    require_number("resolution", checker_.resolution, true);
    require_number("size", checker_.size, true);
  }

  Eigen::Index dimension() const override { return dimension_; }
  double size() const override { return checker_.size; }
  std::string obstacle_name(int obstacle) const override { return obstacle < 0 ? "" : checker_.name; }

  void near(const Vector& x, double, std::vector<Wall>& found) const override {
    found.clear();
    if (!checker_.is_free(x))
      found.push_back({0, -checker_.resolution, Vector::Zero(x.size())});  // no way out is known
  }

  /// There is no distance: 0 where all places that were asked are free.
  MoveClearance clearance(const Vector& a, const Vector& b) const override {
    const double pieces = std::max(1.0, std::ceil((b - a).norm() / checker_.resolution));
    for (double k = 0; k <= pieces; ++k) {
      Vector x = a + k / pieces * (b - a);
      if (!checker_.is_free(x)) return {-checker_.resolution, -checker_.resolution, 0, std::move(x), false};
    }
    return {0, 0, 0, a, false};
  }

  /// No margin would help.
  void along(const Vector&, const Vector&, double, std::vector<Wall>& found) const override { found.clear(); }

  double room(const Vector& a, const Vector& b, double reach) const override {
    return clearance(a, b).upper < 0 ? 0 : std::min(reach, checker_.resolution);
  }

 private:
  Eigen::Index dimension_;
  FreeChecker checker_;
};

}  // namespace

std::shared_ptr<const Walls> make_checker_walls(Eigen::Index dimension, DistanceChecker checker) {
  return std::make_shared<DistanceWalls>(dimension, std::move(checker));
}

std::shared_ptr<const Walls> make_checker_walls(Eigen::Index dimension, FreeChecker checker) {
  return std::make_shared<FreeWalls>(dimension, std::move(checker));
}

}  // namespace leastcost
