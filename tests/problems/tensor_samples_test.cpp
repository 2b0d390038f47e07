// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/tensor/tensor_samples.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "framework/check/observed_order.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Tensors = std::vector<Eigen::Matrix3d>;

template <class Field>
Tensors tensors_at(const SurfaceSamples& samples, Field field) {
  Tensors tensors;
  for (const Eigen::Vector3d& p : samples.positions) tensors.push_back(field(p));
  return tensors;
}

/// Positive definite for |x| <= 2, curved in every direction.
Eigen::Matrix3d smooth_field(const Eigen::Vector3d& x) {
  Eigen::Matrix3d t;
  t << 4 + std::sin(x[0] + x[1]), x[1] * x[2], 0.5 * x[0], x[1] * x[2], 5 + std::cos(2 * x[2]), 0.3, 0.5 * x[0], 0.3,
      3 + x[0] * x[1];
  return t;
}

Eigen::Matrix3d matrix(const TensorJet& jet) {
  const auto& e = jet.value;
  return (Eigen::Matrix3d() << e[0], e[1], e[2], e[1], e[3], e[4], e[2], e[4], e[5]).finished();
}

Eigen::Matrix3d value(const TensorSamples& field, const Eigen::Vector3d& x) {
  TensorJet jet;
  field.evaluate<0>(x, jet);
  return matrix(jet);
}

/// Largest error on the unit sphere, whose vertices are moved along it at random by up to a quarter of an edge.
double error_on_sphere(int levels, bool on_faces) {
  Random random(5);
  PolygonSoup soup = sphere(levels);
  for (Eigen::Vector3d& p : soup.positions) {
    p += 0.35 / (1 << levels) * Eigen::Vector3d(random.vector(3)).normalized();
    p.normalize();
  }
  const TriangleMesh mesh(soup);
  const SurfaceSamples samples = on_faces ? face_samples(mesh) : vertex_samples(mesh);
  const TensorSamples field(samples, tensors_at(samples, smooth_field));
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d x = Eigen::Vector3d(random.vector(3)).normalized();
    worst = std::max(worst, (value(field, x) - smooth_field(x)).cwiseAbs().maxCoeff());
  }
  return worst;
}

}  // namespace

TEST_CASE("sampled tensors: a constant tensor comes back exactly") {
  Random random(1);
  const Eigen::Matrix3d root = random.matrix(3, 3);
  const Eigen::Matrix3d constant = root.transpose() * root + Eigen::Matrix3d::Identity();
  const TriangleMesh mesh(sphere(3));
  for (const SurfaceSamples& samples : {vertex_samples(mesh), face_samples(mesh)}) {
    const TensorSamples field(samples, Tensors(samples.positions.size(), constant));
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d x = 1.1 * random.vector(3);  // on, off and far off the sphere
      CHECK((value(field, x) - constant).cwiseAbs().maxCoeff() <= 1e-13 * constant.norm());
    }
  }
}

TEST_CASE("sampled tensors: second order in the spacing on uneven samples") {
  const bool on_faces = GENERATE(false, true);
  const double coarse = error_on_sphere(3, on_faces), middle = error_on_sphere(4, on_faces),
               fine = error_on_sphere(5, on_faces);
  CAPTURE(on_faces, coarse, middle, fine);
  CHECK(std::log2(coarse / middle) > 1.5);  // the slopes alone, of first order, would bring 1
  CHECK(std::log2(middle / fine) > 1.5);
  CHECK(fine < 0.02);
}

TEST_CASE("sampled tensors: derivatives") {
  Random random(2);
  const PointCloud cloud(torus_cloud(3000), {});
  const SurfaceSamples samples = point_samples(cloud);
  const TensorSamples field(samples, tensors_at(samples, [](const Eigen::Vector3d& x) { return smooth_field(x / 2); }));
  for (int repeat = 0; repeat < 5; ++repeat) {
    Eigen::Vector3d x = samples.positions[static_cast<std::size_t>(500 * repeat)] + 0.02 * random.vector(3);
    const Eigen::Vector3d v = Eigen::Vector3d(random.vector(3)).normalized();
    TensorJet jet;
    field.evaluate<2>(x, jet);
    const Eigen::Matrix<double, 6, 1> first = jet.gradient * v;
    Eigen::Matrix<double, 6, 1> second = Eigen::Matrix<double, 6, 1>::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) second += v[i] * v[j] * jet.hessian.col(TensorJet::column(i, j));
    const auto moved = [&](double h) {
      TensorJet at;
      field.evaluate<0>(x + h * v, at);
      return Eigen::Matrix<double, 6, 1>(at.value - jet.value);
    };
    CHECK(observed_order([&](double h) { return (moved(h) - h * first).norm(); }, 0.02, 1e-13) > 2 - kOrderSlack);
    CHECK(observed_order([&](double h) { return (moved(h) - h * first - h * h / 2 * second).norm(); }, 0.02, 1e-13) >
          3 - kOrderSlack);
    TensorJet gradient_only;
    field.evaluate<1>(x, gradient_only);
    CHECK(gradient_only.value == jet.value);
    CHECK(gradient_only.gradient == jet.gradient);
  }
}

TEST_CASE("sampled tensors: positive definite everywhere, whatever the data does") {
  Random random(3);
  const TriangleMesh mesh(sphere(3));
  const SurfaceSamples samples = vertex_samples(mesh);
  const TensorSamples field(samples, tensors_at(samples, [&](const Eigen::Vector3d&) -> Eigen::Matrix3d {
                              const Eigen::Matrix3d a = random.matrix(3, 3);
                              const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> frame(a * a.transpose());
                              const Eigen::Vector3d values =
                                  Eigen::exp(6 * Eigen::Array3d(random.vector(3)).min(1).max(-1));
                              return frame.eigenvectors() * values.asDiagonal() * frame.eigenvectors().transpose();
                            }));
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d x = 1.5 * random.vector(3);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(value(field, x));
    CHECK(solver.eigenvalues()[0] > 1e-4);  // data: at least exp(-6) = 2.5e-3, of which a slope takes half
  }
}

TEST_CASE("sampled tensors: the sheets of a thin plate") {
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity(), other = 3 * one;
  const auto share_of_other = [&](double thickness) {  // in spacings
    const double spacing = 1.0 / 20;
    SurfaceSamples samples;
    samples.oriented = true;
    for (const double side : {1.0, -1.0})
      for (int i = 0; i < 400; ++i) {
        const auto [x, y] = quasi_random(i + (side > 0 ? 0 : 1000));
        samples.positions.emplace_back(x, y, side * thickness * spacing / 2);
        samples.normals.emplace_back(0, 0, side);
        samples.support.push_back(2 * spacing);
      }
    const TensorSamples field(samples,
                              tensors_at(samples, [&](const Eigen::Vector3d& p) { return p[2] > 0 ? one : other; }));
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
      const auto [x, y] = quasi_random(5000 + i);
      const Eigen::Vector3d p(0.2 + 0.6 * x, 0.2 + 0.6 * y, thickness * spacing / 2);
      worst = std::max(worst, (value(field, p)(0, 0) - 1) / 2);
    }
    return worst;
  };
  CHECK(share_of_other(1.01) < 1e-12);  // beyond half a support
  CHECK(share_of_other(0.7) < 0.15);
  CHECK(share_of_other(0.1) > 0.3);  // the limit of what distance can tell
}

TEST_CASE("sampled tensors: beyond all supports the nearest sample") {
  const SurfaceSamples samples = vertex_samples(TriangleMesh(octahedron()));
  const TensorSamples field(samples, tensors_at(samples, smooth_field));
  CHECK(value(field, {50, 1, 2}).isApprox(smooth_field({1, 0, 0}), 1e-14));
  TensorJet jet;
  field.evaluate<2>({50, 1, 2}, jet);
  CHECK(jet.gradient.isZero(0));
  CHECK(std::isnan(value(field, {NAN, 0, 0})(0, 0)));
}

TEST_CASE("surface samples: numbers and places of the file, whatever became of it") {
  PolygonSoup soup = cube();
  soup.positions.insert(soup.positions.begin() + 2, Eigen::Vector3d(9, 9, 9));  // a vertex that no face uses
  for (std::int32_t& c : soup.corners) c += c >= 2 ? 1 : 0;
  soup.positions.push_back(soup.positions[0]);  // and one that repeats another, used by the first face
  soup.corners[0] = 9;
  const TriangleMesh mesh(soup, {.weld = true, .subdivide = GENERATE(0, 2)});
  const SurfaceSamples vertices = vertex_samples(mesh), faces = face_samples(mesh);
  CHECK(vertices.count_in_file == 10);
  CHECK(vertices.in_file == std::vector<std::int32_t>{0, 1, 3, 4, 5, 6, 7, 8, 9});
  for (std::size_t i = 0; i < vertices.in_file.size(); ++i)
    CHECK(vertices.positions[i] == soup.positions[static_cast<std::size_t>(vertices.in_file[i])]);
  REQUIRE(faces.count_in_file == 6);
  REQUIRE(faces.in_file == std::vector<std::int32_t>{0, 1, 2, 3, 4, 5});
  CHECK(faces.positions[2].isApprox(Eigen::Vector3d(0, -0.5, 0), 1e-9));
  CHECK(faces.normals[2].isApprox(Eigen::Vector3d(0, -1, 0), 1e-9));
  CHECK(faces.support[2] == Approx(2 * std::sqrt(0.5)));
  CHECK(vertices.oriented);
}

TEST_CASE("balls that hold a point: the same as asking every ball") {
  Random random(4);
  std::vector<Eigen::Vector3d> centres;
  std::vector<double> radii;
  for (int i = 0; i < 500; ++i) {
    centres.emplace_back(random.vector(3));
    radii.push_back(std::exp(random.uniform(-5, 0)));
  }
  const BallTree tree(centres, radii);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d x = random.vector(3);
    std::vector<std::int32_t> found, expected;
    const auto holds = [&](std::size_t k) { return (x - centres[k]).norm() < radii[k]; };
    tree.near(x, [&](std::int32_t first, std::int32_t last) {
      for (std::int32_t place = first; place < last; ++place) {
        const std::int32_t k = tree.order()[static_cast<std::size_t>(place)];
        if (holds(static_cast<std::size_t>(k))) found.push_back(k);
      }
    });
    for (std::size_t k = 0; k < centres.size(); ++k)
      if (holds(k)) expected.push_back(static_cast<std::int32_t>(k));
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
  }
}

}  // namespace leastcost::test
