// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "framework/energy/spacing.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {

/// The graph z = -depth exp(-(x / width)^2): flat land with a trench along y. Points are projected along z, which is a
/// retraction.
class TrenchManifold final : public EmbeddedManifold {
 public:
  TrenchManifold(double depth, double width) : EmbeddedManifold({3, 3, 2}), depth_(depth), width_(width) {}
  double height(double x) const { return -depth_ * std::exp(-x * x / (width_ * width_)); }

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    if (!std::isfinite(x[0])) return false;
    x[2] = height(x[0]);
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    const double slope = -2 * x[0] / (width_ * width_) * height(x[0]);
    basis.col(0) = Eigen::Vector3d(1, 0, slope).normalized();
    basis.col(1) = Eigen::Vector3d::UnitY();
  }

 private:
  double depth_, width_;
};

/// Paths from one side of the trench to the other: the right one goes down and up its steep walls; the other stops at
/// the rims and jumps, held there by the land behind (VFCS Fig. 2 b).
struct Trench {
  Trench(double depth, double w) : width(w), manifold(std::make_shared<TrenchManifold>(depth, w)) {}
  double width, reach = 4;
  std::shared_ptr<const TrenchManifold> manifold;

  Problem problem(std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>()) const {
    return between(manifold, make_euclidean_cost(3), Eigen::Vector3d(-reach, 0, manifold->height(-reach)),
                   Eigen::Vector3d(reach, 0.5, manifold->height(reach)), std::move(kernel));
  }
  /// n free points along the surface, equally spaced.
  CoordinatePath through(int n) const {
    CoordinatePath dense{Points(3, 2001), {}, false};
    for (Index i = 0; i <= 2000; ++i) {
      const double t = static_cast<double>(i) / 2000;
      dense.u.col(i) << reach * (2 * t - 1), 0.5 * t, 0;
    }
    manifold->project(dense);
    return sample_equally(problem(), dense, n);
  }
  /// n free points, none of them in the trench.
  CoordinatePath jumping(int n) const {
    CoordinatePath path{Points(3, n + 2), {}, false};
    for (Index i = 0; i < n + 2; ++i) {
      const double t = static_cast<double>(i) / (n + 1);
      const double x = t < 0.5 ? -reach + 2 * t * (reach - 2 * width) : reach - 2 * (1 - t) * (reach - 2 * width);
      path.u.col(i) << x, 0.5 * t, 0;
    }
    manifold->project(path);
    path.u.col(0) = problem().source.u;
    path.u.rightCols(1) = problem().target.u;
    return path;
  }
};

}  // namespace leastcost::test
