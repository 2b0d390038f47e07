// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/certificate/geometry_error.hpp"

#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

/// A sphere whose radius is off by `error`, which grows by `factor` from one version to the next coarser one.
class RoughSphere final : public EmbeddedManifold, public HasCoarserVersion {
 public:
  RoughSphere(double error, double factor, int versions)
      : EmbeddedManifold({3, 3, 2}), error_(error), factor_(factor), versions_(versions) {}
  std::shared_ptr<const ConstraintManifold> coarser() const override {
    if (versions_ == 0) throw InputError("nothing is left");
    return std::make_shared<RoughSphere>(factor_ * error_, factor_, versions_ - 1);
  }
  bool has_made_coarser() const override { return true; }

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    x = (1 + error_) * x.normalized();
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    plane_basis(x.normalized(), basis);
  }

 private:
  double error_, factor_;
  int versions_;
};

Problem quarter(std::shared_ptr<const ConstraintManifold> sphere) {
  return between(std::move(sphere), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0.6, 0.8));
}

GeometryError measured(const std::shared_ptr<const ConstraintManifold>& sphere) {
  const Result result = find(quarter(sphere), 15, WaypointsInitializer(Eigen::Vector3d(0.7, 0.5, 0.5)));
  return measure_geometry_error(quarter(sphere), result.path, {});
}

}  // namespace

// Lengths are proportional to 1 + error: differences (factor - 1) e and (factor^2 - factor) e / 2, doubled.
// Moving every point of an arc outwards by d changes its length by d times its angle, to first order: here as much as
// |C - C_1|.
TEST_CASE("geometry error: twice the largest of what coarser versions show") {
  const double e = 1e-4, chords = 32 * std::sin(std::acos(-1.0) / 4 / 16);
  const GeometryError fourth = measured(std::make_shared<RoughSphere>(e, 4, 5));
  CHECK(fourth.trouble.empty());
  CHECK(fourth.value.value() == Approx(2 * std::max(3.0, 12.0 / 2) * e * chords).epsilon(1e-6));
  const GeometryError slow = measured(std::make_shared<RoughSphere>(e, 1.5, 5));
  CHECK(slow.value.value() == Approx(2 * 0.5 * e * chords).epsilon(1e-6));
  const GeometryError one_level = measured(std::make_shared<RoughSphere>(e, 4, 1));
  CHECK(one_level.value.value() == Approx(2 * 3.0 * e * chords).epsilon(1e-6));
}

TEST_CASE("geometry error: nothing for exact domains, a reason where it cannot be measured") {
  const GeometryError exact = measured(std::make_shared<Sphere>());
  CHECK_FALSE(exact.value);
  CHECK(exact.trouble.empty());
  const auto last = std::make_shared<RoughSphere>(1e-4, 4, 0);
  const GeometryError none = measured(last);
  CHECK_FALSE(none.value);
  CHECK(none.trouble.find("nothing is left") != std::string::npos);
  const Result result = find(quarter(last), 15, WaypointsInitializer(Eigen::Vector3d(0.7, 0.5, 0.5)));
  CHECK(failed(result.certificate, "geometry_error"));
  CHECK(result.status == Status::uncertified);
}

TEST_CASE("geometry error: the certificate carries it, and it covers the error of the domain") {
  const Result result = find(quarter(std::make_shared<RoughSphere>(-1e-4, 2, 5)), 15,
                             WaypointsInitializer(Eigen::Vector3d(0.7, 0.5, 0.5)));
  const Certificate& c = result.certificate;
  CAPTURE(failures(c));
  REQUIRE(c.geometry_error);
  CHECK(c.certified());
  CHECK(std::abs(c.estimate.value - std::acos(0.0)) <= c.estimate.error + *c.geometry_error);
}

}  // namespace leastcost::test
