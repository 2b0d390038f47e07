// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include <leastcost/framework/domain/manifold.hpp>

/// Smooth domains for tests, each the ten lines that an author of one writes.
namespace leastcost::test {

/// Orthonormal columns orthogonal to a unit normal in R^3.
inline void plane_basis(const Eigen::Vector3d& normal, Eigen::Ref<Points> basis) {
  const Eigen::Vector3d e = normal.unitOrthogonal();
  basis << e, normal.cross(e);
}

/// The unit sphere in R^3.
class Sphere final : public EmbeddedManifold {
 public:
  Sphere() : EmbeddedManifold({3, 3, 2}) {}

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    if (!(x.norm() > 0)) return false;
    x.normalize();
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    plane_basis(x.normalized(), basis);
  }
};

/// The torus around the z axis with radii 2 and 1.
class Torus final : public EmbeddedManifold {
 public:
  Torus() : EmbeddedManifold({3, 3, 2}) {}
  static Eigen::Vector3d at(double u, double v) {
    return {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)};
  }

 protected:
  static Eigen::Vector3d core(const Eigen::VectorXd& x) { return 2 * Eigen::Vector3d(x[0], x[1], 0).normalized(); }
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    const Eigen::Vector3d c = core(x), r = x - c;
    if (!(std::hypot(x[0], x[1]) > 0) || !(r.norm() > 0)) return false;
    x = c + r.normalized();
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    plane_basis((x - core(x)).normalized(), basis);
  }
};

}  // namespace leastcost::test
