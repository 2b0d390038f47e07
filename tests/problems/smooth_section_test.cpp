// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Plane cuts of smooth surfaces, however they are given.
#include "problems/section/smooth_section.hpp"

#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const ConstraintManifold> torus_of(const std::string& kind) {
  if (kind == "implicit") {
    return make_implicit_manifold({.surface = implicit::Torus{}});
  }
  if (kind == "chart") {
    return make_parametric_manifold({.surface = parametric::Torus{}});
  }
  return std::make_shared<PointCloudManifold>(PointCloud(torus_cloud(3000, 1), {}));
}

std::shared_ptr<const ParametricManifold> chart(const char* type, const BoxOptions& box = {}) {
  return make_parametric_manifold({.surface = form<parametric::Surface>(type), .box = box});
}

/// The ring in space, closed.
Points closed_curve(const ConstraintManifold& surface, const CoordinatePath& ring) {
  CoordinatePath all = ring;
  all.u.conservativeResize(Eigen::NoChange, ring.u.cols() + 1);
  all.u.rightCols(1) = ring.column(ring.u.cols());
  return positions(surface, all);
}

double length_of(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

std::string refusal(const ConstraintManifold& surface, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  try {
    smooth_section(surface, point, normal.normalized());
    return "accepted";
  } catch (const InitializationError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("plane cuts of a torus: the circle near the point, in every representation", "[problems]") {
  const std::string kind = GENERATE("implicit", "chart", "cloud");
  const double off = kind == "cloud" ? 2e-3 : 1e-10;  // of a cloud: what the samples cost
  const auto torus = torus_of(kind);
  const double height = 0.3, in = 2 - std::sqrt(1 - height * height), out = 2 + std::sqrt(1 - height * height);
  for (const double radius : {in, out}) {
    const Eigen::Vector3d near(0.98 * radius, 0.1, height);
    const CoordinatePath ring = smooth_section(*torus, near, Eigen::Vector3d::UnitZ());
    const Points x = closed_curve(*torus, ring);
    CAPTURE(kind, radius, x.cols());
    CHECK((x.row(2).array() - height).abs().maxCoeff() <= 1e-11);
    CHECK((x.topRows(2).colwise().norm().array() - radius).abs().maxCoeff() <= off);
    CHECK(length_of(x) == Approx(2 * kPi * radius).epsilon(0.01));  // once around: chords of steps up to 0.2 radians
    CHECK((x.rightCols(1) - x.col(0)).norm() <= 1e-9);
  }
  // Around the tube.
  const Points x = closed_curve(*torus, smooth_section(*torus, {2, 0, 1.02}, Eigen::Vector3d::UnitY()));
  CHECK(length_of(x) == Approx(2 * kPi).epsilon(0.01));
  CHECK(x.row(1).cwiseAbs().maxCoeff() <= 1e-11);
}

TEST_CASE("plane cuts of smooth surfaces: seams, and what is no closed curve", "[problems]") {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  // A slanted ellipse around a cylinder closes on an image.
  const auto cylinder = chart("cylinder");
  const CoordinatePath around = smooth_section(*cylinder, Eigen::Vector3d(1, 0, 0.2), (z + x).normalized());
  CHECK(std::abs(around.closing.shift[0]) == Approx(2 * kPi));
  CHECK((around.column(around.u.cols()) - around.u.rightCols(1)).norm() < 0.5);
  CHECK_THAT(refusal(*cylinder, x, x + 0.3 * Eigen::Vector3d::UnitY()), Catch::Contains("does not close"));
  CHECK_THAT(refusal(*chart("catenoid", {Eigen::Vector2d(-99, -1), Eigen::Vector2d(99, 1)}), {1, 0, 0},
                     x + 0.2 * z + Eigen::Vector3d(0, 1, 0)),
             Catch::Contains("leaves the domain"));
  CHECK_THAT(refusal(*torus_of("implicit"), {0, 0, 5}, z), Catch::Contains("no point of the surface was found"));
  CHECK_THAT(refusal(*torus_of("cloud"), {0, 0, 5}, z), Catch::Contains("no point of the surface was found"));
  // A sphere's meridian goes over the poles of its chart.
  CHECK_THAT(refusal(*chart("sphere"), {1, 0, 0}, Eigen::Vector3d::UnitY()), Catch::Contains("pole"));
  CHECK(refusal(*chart("sphere"), {1, 0, 0}, {0.3, 0, 1}) == "accepted");
}

TEST_CASE("rings from plane cuts settle as the closed geodesics of a torus", "[problems]") {
  const std::string kind = GENERATE("implicit", "chart", "cloud");
  const Problem problem = closed(torus_of(kind), make_euclidean_cost(3));
  const Eigen::Vector3d slanted(0.05, 0.02, 1);
  const Result waist = find(problem, 100, PlaneCutInitializer({Eigen::Vector3d(1.05, 0, 0.1), slanted}));
  const CostEstimate& e = waist.certificate.estimate;
  CAPTURE(kind, e.value, e.error, failures(waist.certificate));
  CHECK(waist.status == Status::certified);
  CHECK(std::abs(e.value - 2 * kPi) <= e.error + waist.certificate.geometry_error.value_or(0));
  CHECK(std::abs(e.value - 2 * kPi) <= (kind == "cloud" ? 1e-2 : 1e-6));
}

}  // namespace leastcost::test
