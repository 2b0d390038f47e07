// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/tensor/curvature.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// S^2 of the torus with radii 2 and 1: 1 along the meridian, (cos v / (2 + cos v))^2 around the axis.
Eigen::Matrix3d torus_third_form(const Eigen::Vector3d& p) {
  const double rho = std::hypot(p[0], p[1]);
  const Eigen::Vector3d out(p[0] / rho, p[1] / rho, 0), around(-out[1], out[0], 0);
  const Eigen::Vector3d radial = Eigen::Vector3d((rho - 2) * out + p[2] * Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d meridian = around.cross(radial);
  const double c = radial.dot(out), k = c / (2 + c);
  return meridian * meridian.transpose() + k * k * around * around.transpose();
}

/// Errors of S^2 at all samples, ascending.
template <class Exact>
std::vector<double> errors(const SurfaceSamples& samples, double radius, Exact exact) {
  const std::vector<Eigen::Matrix3d> shapes = shape_operators(samples, radius);
  std::vector<double> all;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    all.push_back((shapes[i] * shapes[i] - exact(samples.positions[i])).norm());
  std::sort(all.begin(), all.end());
  return all;
}

SurfaceSamples torus_mesh(int n) {
  return vertex_samples(TriangleMesh(sheet(2 * n, n, [](double s, double t) -> Eigen::Vector3d {
    const double u = 2 * kPi * s, v = 2 * kPi * t;
    return {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)};
  })));
}

}  // namespace

TEST_CASE("curvature: a sphere, a cylinder and a torus as meshes, by second order") {
  const TriangleMesh ball(sphere(4));
  const std::vector<double> of_ball = errors(
      vertex_samples(ball), 2.5,
      [](const Eigen::Vector3d& p) -> Eigen::Matrix3d { return Eigen::Matrix3d::Identity() - p * p.transpose(); });
  CHECK(of_ball.back() < 0.1);
  std::vector<double> of_torus, at_seam;
  for (const int n : {16, 32, 64}) {
    const std::vector<double> all = errors(torus_mesh(n), 2.5, torus_third_form);
    of_torus.push_back(all[all.size() / 2]);
    at_seam.push_back(all.back());  // the sheet does not close: its border has neighbours on one side only
  }
  CAPTURE(of_torus, at_seam);
  CHECK(std::log2(of_torus[1] / of_torus[2]) > 1.7);
  CHECK(std::log2(at_seam[1] / at_seam[2]) > 0.7);
  const SurfaceSamples tube = vertex_samples(TriangleMesh(sheet(60, 20, [](double s, double t) -> Eigen::Vector3d {
    return {0.5 * std::cos(2 * kPi * s), 0.5 * std::sin(2 * kPi * s), t};
  })));
  const std::vector<double> of_tube = errors(tube, 2.5, [](const Eigen::Vector3d& p) -> Eigen::Matrix3d {
    const Eigen::Vector3d around(-2 * p[1], 2 * p[0], 0);
    return 4 * around * around.transpose();
  });
  CHECK(of_tube.back() < 0.04 * 4);
}

TEST_CASE("curvature: a sampled torus, clean and noisy") {
  std::vector<double> medians;
  for (const int count : {2000, 8000}) {
    const PointCloud cloud(torus_cloud(count), {});
    const std::vector<double> all = errors(point_samples(cloud), 4, torus_third_form);
    medians.push_back(all[all.size() / 2]);
  }
  CAPTURE(medians);
  CHECK(std::log2(medians[0] / medians[1]) > 0.7);  // first order: the neighbours are uneven
  CHECK(medians[1] < 0.05);
  Random random(6);
  PointSamples noisy = torus_cloud(8000);
  for (Eigen::Vector3d& p : noisy.positions) p += 0.01 * random.vector(3);  // a seventh of the spacing
  const PointCloud cloud(noisy, {});
  const std::vector<double> all = errors(point_samples(cloud), 8, torus_third_form);
  CAPTURE(all[all.size() / 2], *cloud.settings().radius);
  CHECK(all[all.size() / 2] < 0.3);  // of curvatures of 1
}

TEST_CASE("curvature: a crease is seen, and its direction") {
  const double angle = 1;  // between the normals
  const SurfaceSamples roof = vertex_samples(TriangleMesh(sheet(20, 20, [&](double s, double t) -> Eigen::Vector3d {
    const double x = s - 0.5;
    return {x * std::cos(angle / 2), t, -std::abs(x) * std::sin(angle / 2)};
  })));
  const std::vector<Eigen::Matrix3d> shapes = shape_operators(roof, 2.5);
  const auto at = [&](int i, int j) { return shapes[static_cast<std::size_t>(21 * i + j)]; };
  const double on_ridge = at(10, 10).norm(), beside = at(3, 10).norm();
  CHECK(on_ridge > 3);  // the angle over the radius of 0.16 makes 6
  CHECK(beside < 1e-9);
  CHECK(std::abs((at(10, 10) * Eigen::Vector3d::UnitY()).norm()) < 0.1 * on_ridge);  // straight along the ridge
}

TEST_CASE("curvature: too few neighbours count as flat") {
  const SurfaceSamples single = vertex_samples(TriangleMesh(octahedron()));
  for (const Eigen::Matrix3d& shape : shape_operators(single, 3)) CHECK(shape.isZero(0));
  const std::vector<Eigen::Matrix3d> metric = isophotic_metric(shape_operators(single, 3), 2);
  CHECK(metric.front() == Eigen::Matrix3d::Identity());
}

}  // namespace leastcost::test
