// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/chart/chart_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/problems/chart/seams.hpp>

namespace leastcost {
namespace {

constexpr int kGrid = 24;       ///< starts per coordinate
constexpr int kKept = 8;        ///< best ones that are improved
constexpr int kMostSteps = 40;  ///< Gauss-Newton

class ChartSearch {
 public:
  ChartSearch(const ConstraintManifold& surface, const Eigen::Vector3d& position)
      : surface_(surface), chart_(find_ability<HasChart>(surface)), position_(position) {}

  std::vector<Eigen::VectorXd> run() {
    if (chart_ == nullptr) return {};
    std::vector<Found> found;
    const auto [low, high] = ranges();
    for (int i = 0; i < kGrid; ++i)
      for (int j = 0; j < kGrid; ++j) {
        const Eigen::Vector2d t((i + 0.5) / kGrid, (j + 0.5) / kGrid);
        const Eigen::VectorXd u = low + t.cwiseProduct(high - low);
        const double d = distance(u);
        if (std::isfinite(d)) found.push_back({d, u});
      }
    const auto nearer = [](const Found& a, const Found& b) { return a.distance < b.distance; };
    std::sort(found.begin(), found.end(), nearer);
    if (found.size() > kKept) found.resize(kKept);
    for (Found& f : found) improve(f);
    std::sort(found.begin(), found.end(), nearer);
    std::vector<Eigen::VectorXd> points;
    points.reserve(found.size());
    for (Found& f : found) points.push_back(std::move(f.u));
    return points;
  }

 private:
  struct Found {
    double distance = 0;
    Eigen::VectorXd u;
  };

  /// A far point of the chart, which its bounds move to where they are.
  std::pair<Eigen::Vector2d, Eigen::Vector2d> ranges() const {
    constexpr double kFar = 1e6;
    const double size = 2 + 2 * position_.norm();
    Eigen::Vector2d low = Eigen::Vector2d::Constant(-size), high = Eigen::Vector2d::Constant(size);
    for (Index i = 0; i < 2; ++i) {
      for (const double side : {-1.0, 1.0}) {
        CoordinatePath one{Eigen::VectorXd::Constant(2, 0.5), {}, true};
        one.u(i, 0) = side * kFar;
        const bool bounded = surface_.project(one).failed.empty() && std::abs(one.u(i, 0)) < kFar;
        if (bounded) (side < 0 ? low : high)[i] = one.u(i, 0);
      }
      low[i] = std::min(low[i], high[i]);
    }
    if (const auto* domain = find_ability<HasSeams>(surface_))
      for (const Seam& seam : domain->seams()) high[seam.coordinate] = low[seam.coordinate] + seam.period;
    return {low, high};
  }

  double distance(const Eigen::VectorXd& u) {
    one_.u = u;
    if (!surface_.project(one_).failed.empty()) return std::numeric_limits<double>::infinity();
    chart_->embed(one_, x_);
    return (x_.col(0) - position_).norm();
  }

  void improve(Found& f) {
    Points j;
    for (int i = 0; i < kMostSteps; ++i) {
      one_.u = f.u;
      chart_->embed(one_, x_);
      chart_->jacobians(one_, j);
      const Eigen::Vector2d step =
          (j.transpose() * j).ldlt().solve(j.transpose() * (position_ - Eigen::Vector3d(x_.col(0))));
      if (!step.allFinite() || step.norm() <= 1e-12 * (1 + f.u.norm())) return;
      double part = 1;
      for (; part > 1e-4; part /= 2) {
        const Eigen::VectorXd trial = f.u + part * step;
        const double d = distance(trial);
        if (!(d < f.distance)) continue;
        f = {d, one_.u.col(0)};
        break;
      }
      if (part <= 1e-4) return;
    }
  }

  const ConstraintManifold& surface_;
  const HasChart* chart_;
  Eigen::Vector3d position_;
  CoordinatePath one_{Points(2, 1), {}, true};
  Points x_;
};

}  // namespace

std::vector<Eigen::VectorXd> nearest_in_chart(const ConstraintManifold& chart, const Eigen::Vector3d& position) {
  return ChartSearch(chart, position).run();
}

}  // namespace leastcost
