// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Domains with one defect each: check_manifold() names it.
#include <leastcost/framework/check/check_manifold.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

enum class DomainDefect { none, slow_projection, long_basis, wrong_plane, overshoots, first_order, moves_ends };

/// The unit sphere, and one defect.
class Globe final : public EmbeddedManifold {
 public:
  explicit Globe(DomainDefect defect) : EmbeddedManifold({3, 3, 2}), defect_(defect) {}

  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override {
    Points bent = step;
    if (defect_ == DomainDefect::overshoots) bent *= 2;
    if (defect_ == DomainDefect::first_order)  // slides sideways at second order
      for (Index i = 0; i < step.cols(); ++i)
        bent.col(i) +=
            step.col(i).norm() * Eigen::Vector3d(from.u.col(from.free_begin() + i)).cross(Eigen::Vector3d(step.col(i)));
    EmbeddedManifold::retract(from, bent, to);
    if (defect_ == DomainDefect::moves_ends) to.u = -to.u;
  }

 private:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    if (!(x.norm() > 0)) return false;
    x *= defect_ == DomainDefect::slow_projection ? 0.5 + 0.5 / x.norm() : 1 / x.norm();
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    const Eigen::Vector3d n = defect_ == DomainDefect::wrong_plane ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(x);
    basis.col(0) = n.unitOrthogonal();
    basis.col(1) = n.cross(Eigen::Vector3d(basis.col(0)));
    if (defect_ == DomainDefect::long_basis) basis.col(0) *= 1.001;
  }

  DomainDefect defect_;
};

/// x >= 0 in the plane, with normals that point outwards or not.
class HalfSpace final : public EmbeddedManifold, public HasBounds {
 public:
  explicit HalfSpace(double normal) : EmbeddedManifold({2, 2, 2}), normal_(normal) {}
  Shape shape() const override { return Shape::flat; }
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override {
    if (path.u(0, column) > 0) return 0;
    normals.col(0) = normal_ * Eigen::Vector2d::UnitX();
    return 1;
  }

 private:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    x[0] = std::max(0.0, x[0]);
    return true;
  }
  void tangent_basis(const Eigen::VectorXd&, Eigen::Ref<Points> basis) const override { basis.setIdentity(); }

  double normal_;
};

/// The graph z = u^2 v over the plane; derivatives times a factor.
class GraphSurface final : public EmbeddedManifold, public HasChart {
 public:
  GraphSurface(double first, double second) : EmbeddedManifold({2, 3, 2}), first_(first), second_(second) {}
  std::vector<std::string> coordinate_names() const override { return {"u", "v"}; }
  Shape shape() const override { return Shape::smooth; }
  void embed(const CoordinatePath& path, Points& x) const override {
    x.resize(3, path.u.cols());
    x.topRows(2) = path.u;
    x.row(2) = path.u.row(0).array().square() * path.u.row(1).array();
  }
  void jacobians(const CoordinatePath& path, Points& j) const override {
    j = Points::Zero(3, 2 * path.u.cols());
    for (Index i = 0; i < path.u.cols(); ++i) {
      const double u = path.u(0, i), v = path.u(1, i);
      j(0, 2 * i) = j(1, 2 * i + 1) = 1;
      j(2, 2 * i) = first_ * 2 * u * v;
      j(2, 2 * i + 1) = first_ * u * u;
    }
  }
  void curvatures(const CoordinatePath& path, const Points& weights, Points& h) const override {
    h.resize(2, 2 * path.u.cols());
    for (Index i = 0; i < path.u.cols(); ++i) {
      const double u = path.u(0, i), v = path.u(1, i);
      h.middleCols(2 * i, 2) << 2 * v, 2 * u, 2 * u, 0;
      h.middleCols(2 * i, 2) *= second_ * weights(2, i);
    }
  }
  const std::vector<SeamMap>& poles() const override {
    static const std::vector<SeamMap> none;
    return none;
  }

 private:
  bool project_point(Eigen::Ref<Eigen::VectorXd>) const override { return true; }
  void tangent_basis(const Eigen::VectorXd&, Eigen::Ref<Points> basis) const override { basis.setIdentity(); }

  double first_, second_;
};

std::string named(const ConstraintManifold& manifold, const PointSampler& near,
                  const CheckManifoldOptions& options = {}) {
  std::mt19937_64 engine(5);
  std::string names;
  for (const Fault& fault : check_manifold(manifold, near, engine, options))
    names += (names.empty() ? "" : " ") + fault.name;
  return names;
}

std::string named(DomainDefect defect) {
  return named(Globe(defect), [](std::mt19937_64& engine) -> Eigen::VectorXd {
    std::normal_distribution<double> normal;
    const Eigen::Vector3d x(normal(engine), normal(engine), normal(engine));
    return x.normalized() * std::uniform_real_distribution<double>(0.9, 1.1)(engine);
  });
}

}  // namespace

TEST_CASE("check_manifold: the sphere has no faults, each defect its name", "[framework]") {
  CHECK(named(DomainDefect::none) == "");
  CHECK(named(DomainDefect::long_basis) == "tangent_bases");
  CHECK(named(DomainDefect::overshoots) == "retraction second_order");
  CHECK(named(DomainDefect::first_order) == "second_order");
  CHECK_THAT(named(DomainDefect::slow_projection), Catch::Contains("idempotent"));
  CHECK_THAT(named(DomainDefect::wrong_plane), Catch::Contains("tangent_bases"));
  CHECK_THAT(named(DomainDefect::moves_ends), Catch::Contains("retraction"));
}

TEST_CASE("check_manifold: bounds and charts", "[framework]") {
  const PointSampler plane = sample_box(Eigen::Vector2d(0.5, -1), Eigen::Vector2d(2, 1));
  const CheckManifoldOptions on_bound{.special = {Eigen::Vector2d(0, 0.3), Eigen::Vector2d(-1e-8, 0.3)}};
  CHECK(named(HalfSpace(1), plane) == "");
  CHECK(named(HalfSpace(-1), plane, on_bound) == "");
  CHECK(named(HalfSpace(1), plane, on_bound) == "bounds");
  CHECK(named(HalfSpace(-2), plane, on_bound) == "bounds");
  CHECK(named(GraphSurface(1, 1), plane) == "");
  CHECK(named(GraphSurface(1.01, 1), plane) == "chart_jacobian chart_curvature");
  CHECK(named(GraphSurface(1, 1.01), plane) == "chart_curvature");
}

}  // namespace leastcost::test
