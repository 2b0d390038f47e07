// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/section/plane_station.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leastcost {
namespace {

constexpr double kOnPlane = 1e-12;  ///< relative to the size of the coordinates
constexpr double kTouching = 1e-6;  ///< sine of the angle below which plane and surface touch
constexpr int kMostNewtonSteps = 30;

}  // namespace

Eigen::VectorXd Station::pulled_back(const Eigen::Vector3d& d) const {
  return basis * (lift.transpose() * lift).ldlt().solve(lift.transpose() * d);
}

Eigen::Vector3d Station::surface_normal() const {
  return Eigen::Vector3d(lift.col(0)).cross(Eigen::Vector3d(lift.col(1))).normalized();
}

StationFinder::StationFinder(const ConstraintManifold& surface, const Eigen::Vector3d& point,
                             const Eigen::Vector3d& normal)
    : surface_(&surface),
      chart_(find_ability<HasChart>(surface)),
      point_(point),
      normal_(normal),
      one_{Points(surface.dimensions().coordinate, 1), {}, true} {}

/// Projects u onto the surface and looks around there.
bool StationFinder::place(const Eigen::VectorXd& u, Station& out) {
  one_.u.col(0) = u;
  if (!u.allFinite() || !surface_->project(one_).failed.empty()) return false;
  out.u = one_.u.col(0);
  surface_->tangent_bases(one_, out.basis);
  if (chart_ != nullptr) {
    chart_->embed(one_, position_);
    chart_->jacobians(one_, jacobian_);
    out.x = position_.col(0);
    out.lift = jacobian_ * out.basis;
  } else {
    out.x = out.u;
    out.lift = out.basis;
  }
  const Eigen::Vector3d area = Eigen::Vector3d(out.lift.col(0)).cross(Eigen::Vector3d(out.lift.col(1)));
  out.along = normal_.cross(area);
  if (!(out.along.norm() > kTouching * area.norm())) return false;  // or the chart has a pole there
  out.along.normalize();
  return true;
}

/// Newton steps onto the plane, the shortest ones in the tangent plane.
bool StationFinder::correct(Station& s) {
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    const double height = normal_.dot(s.x - point_), size = s.x.norm() + point_.norm();
    if (std::abs(height) <= kOnPlane * std::max(std::numeric_limits<double>::min(), size)) return true;
    if (!(std::abs(height) < before) && i > 3) return std::abs(height) <= 1e3 * kOnPlane * size;
    before = std::abs(height);
    const Eigen::Vector3d n = s.surface_normal(), up = normal_ - normal_.dot(n) * n;
    Station next;
    if (!place(s.u + s.pulled_back(-height / up.squaredNorm() * up), next)) return false;
    s = std::move(next);
  }
  return false;
}

std::optional<Station> StationFinder::reach(const Eigen::VectorXd& u) {
  Station s;
  if (!place(u, s) || !correct(s)) return std::nullopt;
  return s;
}

}  // namespace leastcost
