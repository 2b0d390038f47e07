// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/level_set/named_surfaces.hpp"

#include <numbers>
#include <span>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

/// (|x|^2 / R - R) / 2, whose gradient is a unit vector on the sphere.
class SphereFunction final : public ConstraintFunction, private LevelSetEnclosure {
 public:
  SphereFunction(int dimension, double radius) : dimension_(dimension), radius_(radius) {}
  int inputs() const override { return dimension_; }
  int outputs() const override { return 1; }
  void evaluate(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> value,
                Eigen::Ref<Points> gradients) const override {
    value[0] = (x.squaredNorm() / radius_ - radius_) / 2;
    gradients.col(0) = x / radius_;
  }
  bool knows_curvature() const override { return true; }
  void curvature(const Eigen::Ref<const Eigen::VectorXd>&, const Eigen::Ref<const Eigen::VectorXd>& weights,
                 Eigen::Ref<Points> out) const override {
    out.setZero();
    out.diagonal().setConstant(weights[0] / radius_);
  }
  const LevelSetEnclosure* enclosure() const override { return dimension_ == 3 ? this : nullptr; }

 private:
  IntervalJet<3> enclose(std::span<const IntervalJet<3>, 3> x) const override { return value_at(x); }
  Sloped enclose(std::span<const Sloped, 3> x) const override { return value_at(x); }

  template <class S>
  S value_at(std::span<const S, 3> x) const {
    return ((x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / S(radius_) - radius_) / S(2.0);
  }

  int dimension_;
  double radius_;
};

struct Ellipsoid {
  static constexpr int inputs = 3, outputs = 1;
  static constexpr bool encloses = true;
  Eigen::Vector3d inverse;  ///< 1/a, 1/b, 1/c
  template <class S>
  S value(const Point<S, 3>& p) const {
    const S x = p[0] * inverse[0], y = p[1] * inverse[1], z = p[2] * inverse[2];
    return x * x + y * y + z * z - 1.0;
  }
};

struct Torus {
  static constexpr int inputs = 3, outputs = 1;
  static constexpr bool encloses = true;
  double major_radius, minor_radius;
  template <class S>
  S value(const Point<S, 3>& p) const {
    using std::sqrt;
    const S off = sqrt(p[0] * p[0] + p[1] * p[1]) - major_radius;
    return off * off + p[2] * p[2] - minor_radius * minor_radius;
  }
};

struct Genus2 {
  static constexpr int inputs = 3, outputs = 1;
  static constexpr bool encloses = true;
  template <class S>
  S value(const Point<S, 3>& p) const {
    const S x2 = p[0] * p[0], y2 = p[1] * p[1], z2 = p[2] * p[2], cap = 1.0 - z2, r2 = x2 + y2;
    return 2.0 * p[1] * (y2 - 3.0 * x2) * cap + r2 * r2 - (9.0 * z2 - 1.0) * cap;
  }
};

struct Gyroid {
  static constexpr int inputs = 3, outputs = 1;
  static constexpr bool encloses = true;
  double scale;  ///< 2 pi / period
  template <class S>
  S value(const Point<S, 3>& p) const {
    using std::cos, std::sin;
    const S x = p[0] * scale, y = p[1] * scale, z = p[2] * scale;
    return sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x);
  }
};

struct PaperCurve {
  static constexpr int inputs = 2, outputs = 1;
  template <class S>
  S value(const Point<S, 2>& p) const {
    using std::cos, std::sin;
    const S x2 = p[0] * p[0];
    return x2 * x2 + p[1] * p[1] + 3.0 * p[0] * p[1] + 3.0 * sin(p[0]) * cos(p[1]) - 1.0;
  }
};

void check_positive(double length, const char* key) {
  if (!(length > 0) || !std::isfinite(length)) throw OptionError(key, "must be positive and finite");
}

}  // namespace

std::shared_ptr<const ConstraintFunction> make_sphere_function(int dimension, double radius) {
  check_positive(radius, "radius");
  return std::make_shared<SphereFunction>(dimension, radius);
}

std::shared_ptr<const ConstraintFunction> make_ellipsoid_function(const Eigen::VectorXd& axes) {
  if (axes.size() != 3)
    throw OptionError("axes", std::to_string(axes.size()) + " numbers; give three semi-axes, [a, b, c]");
  for (const double axis : axes) check_positive(axis, "axes");
  return make_constraint_function(Ellipsoid{axes.cwiseInverse()});
}

std::shared_ptr<const ConstraintFunction> make_torus_function(double major_radius, double minor_radius) {
  check_positive(minor_radius, "minor_radius");
  check_positive(major_radius, "major_radius");
  if (!(minor_radius < major_radius))
    throw OptionError("minor_radius", "must be smaller than major_radius, or the torus intersects itself");
  return make_constraint_function(Torus{major_radius, minor_radius});
}

std::shared_ptr<const ConstraintFunction> make_genus2_function() { return make_constraint_function(Genus2{}); }

std::shared_ptr<const ConstraintFunction> make_gyroid_function(double period) {
  check_positive(period, "period");
  return make_constraint_function(Gyroid{2 * std::numbers::pi / period});
}

std::shared_ptr<const ConstraintFunction> make_paper_curve_function() { return make_constraint_function(PaperCurve{}); }

}  // namespace leastcost
