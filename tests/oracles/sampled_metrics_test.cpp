// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Metrics given on the data, meshes and clouds, against closed forms and against the same metric given otherwise.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "problems/mesh/mesh_curve.hpp"
#include "problems/mesh/trace.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

template <class Position>
std::shared_ptr<const MeshManifold> mesh_sheet(int m, int n, Position position) {
  return std::make_shared<MeshManifold>(TriangleMesh(sheet(m, n, position)));
}

/// The tensors of a field at the samples, through a file.
template <class Field>
std::shared_ptr<const SegmentCost> from_file(const std::shared_ptr<const ConstraintManifold>& domain, TensorPlace on,
                                             Field field) {
  const auto* mesh = dynamic_cast<const HasMesh*>(domain.get());
  const SurfaceSamples samples = mesh == nullptr ? point_samples(dynamic_cast<const HasPointCloud&>(*domain).cloud())
                                 : on == TensorPlace::faces ? face_samples(mesh->mesh())
                                                            : vertex_samples(mesh->mesh());
  std::vector<Matrix3d> rows(static_cast<std::size_t>(samples.count_in_file));
  for (std::size_t i = 0; i < samples.positions.size(); ++i)
    rows[static_cast<std::size_t>(samples.in_file[i])] = field(samples.positions[i]);
  const ScratchDir folder;
  std::ofstream out(folder / "tensors.txt");
  out.precision(17);
  for (const Matrix3d& t : rows)
    out << t(0, 0) << ' ' << t(0, 1) << ' ' << t(0, 2) << ' ' << t(1, 1) << ' ' << t(1, 2) << ' ' << t(2, 2) << '\n';
  out.close();
  MetricFieldOptions options;
  options.field = TensorFileOptions{.file = "tensors.txt", .on = on};
  return make_metric_field_cost(options, 3, domain.get(), folder.path());
}

std::shared_ptr<const SegmentCost> curvature(const ConstraintManifold& domain, double weight) {
  MetricFieldOptions options;
  options.field = CurvatureMetricOptions{.weight = weight};
  return make_metric_field_cost(options, 3, &domain);
}

/// What a run does on a mesh with such a cost: traced, not straightened.
Result find_traced(const Problem& problem, int points) {
  FindOptions options;
  options.points = points;
  options.post_processors = {std::make_shared<const TracePostProcessor>()};
  return find_path(problem, DijkstraInitializer(), Lbfgs(), options);
}

Vector3d bump(double s, double t) {
  return {s, t, 0.3 * std::exp(-10 * ((s - 0.5) * (s - 0.5) + (t - 0.4) * (t - 0.4)))};
}

}  // namespace

TEST_CASE("tensors from a file: a multiple of the identity, a constant tensor", "[oracle]") {
  const auto mesh = mesh_sheet(24, 24, bump);
  const TensorPlace on = GENERATE(TensorPlace::vertices, TensorPlace::faces);
  const Vector3d a = mesh->mesh().position(30), b = mesh->mesh().position(570);
  const Result plain = find_traced(between(mesh, make_euclidean_cost(3), a, b), 31);
  const Result scaled = find_traced(
      between(mesh, from_file(mesh, on, [](const Vector3d&) -> Matrix3d { return 4 * Matrix3d::Identity(); }), a, b),
      31);
  CHECK(scaled.curve.cost == Approx(2 * plain.curve.cost).epsilon(1e-6));  // kinks: each as exact as its bundle steps
  MetricTensorOptions constant;
  constant.matrix = (Matrix3d() << 4, 1, 0, 1, 2, 0.3, 0, 0.3, 5).finished();
  const Result given = find_traced(between(mesh, make_metric_tensor_cost(constant, 3), a, b), 31);
  const Result sampled = find_traced(
      between(mesh, from_file(mesh, on, [&](const Vector3d&) -> Matrix3d { return constant.matrix; }), a, b), 31);
  // What is known to be constant is not pulled straight between the points: straightening would do the whole of it.
  CHECK(sampled.curve.cost == Approx(given.curve.cost).epsilon(1e-5));
  CHECK(sampled.curve.cost <= given.curve.cost * (1 + 1e-6));
  CHECK(sampled.certificate.scope == given.certificate.scope);
  CHECK(failures(sampled.certificate) == "certified");
}

TEST_CASE("tensors from a file: half-plane on a mesh, second order in the spacing", "[oracle]") {
  const double exact = 1.49099630899480838;  // D3
  const TensorPlace on = GENERATE(TensorPlace::vertices, TensorPlace::faces);
  std::vector<double> errors;
  for (const int n : {32, 64, 128}) {
    const auto mesh = mesh_sheet(n, n, [](double s, double t) -> Vector3d { return {3 * s - 0.5, 0.5 + 3 * t, 0}; });
    const auto cost = from_file(mesh, on, [](const Vector3d& p) -> Matrix3d {
      return Vector3d(1 / (p[1] * p[1]), 1 / (p[1] * p[1]), 1).asDiagonal();
    });
    const Result result = find_traced(between(mesh, cost, Vector3d(0, 1, 0), Vector3d(2, 3, 0)), 2 * n - 1);
    CAPTURE(n, failures(result.certificate));
    CHECK(result.certificate.certified());
    errors.push_back(result.certificate.estimate.value / exact - 1);
  }
  CAPTURE(word_of(on), errors);
  std::printf("half-plane from tensors on %s: relative errors %.1e %.1e %.1e\n", std::string(word_of(on)).c_str(),
              errors[0], errors[1], errors[2]);
  CHECK(std::log2(std::abs(errors[0] / errors[1])) > 1.7);
  CHECK(std::log2(std::abs(errors[1] / errors[2])) > 1.7);
  CHECK(std::abs(errors[2]) < 2e-4);
}

/// A cylinder of radius r unrolls under the isophotic metric as well: ds^2 = dz^2 + (1 + w^2 / r^2) r^2 dphi^2,
/// straight lines.
TEST_CASE("isophotic metric: a cylinder as a mesh, second order", "[oracle]") {
  const double r = 0.5, w = 0.8, phi = 2, dz = 1.2, exact = std::hypot(dz, std::hypot(r, w) * phi);
  std::vector<double> errors;
  for (const int n : {16, 32, 64}) {
    const auto mesh = mesh_sheet(n, n, [&](double s, double t) -> Vector3d {
      const double angle = 4 * s - 1;
      return {r * std::cos(angle), r * std::sin(angle), 3 * t - 0.9};
    });
    const Vector3d a(r, 0, 0), b(r * std::cos(phi), r * std::sin(phi), dz);
    const Result result = find_traced(between(mesh, curvature(*mesh, w), a, b), 2 * n - 1);
    CAPTURE(n, failures(result.certificate));
    CHECK(result.certificate.certified());
    errors.push_back(result.certificate.estimate.value / exact - 1);
  }
  CAPTURE(errors);
  std::printf("isophotic cylinder, mesh: relative errors %.1e %.1e %.1e\n", errors[0], errors[1], errors[2]);
  CHECK(std::log2(std::abs(errors[0] / errors[1])) > 1.6);
  CHECK(std::log2(std::abs(errors[1] / errors[2])) > 1.6);
  CHECK(std::abs(errors[2]) < 0.01);
}

/// Under tensors on data, though they be the identity, no post-processor straightens the whole curve. Two points on
/// either side of a ridge: the plane of VFCS Eq. (16) does not cut it along the shortest way.
TEST_CASE("tensors from a file: the way between two points over a fold is the shortest", "[oracle]") {
  const double slope = 3, u = std::hypot(1, slope);  // of the unfolded roof, per unit of s
  const auto roof = mesh_sheet(10, 7, [&](double s, double t) -> Vector3d {
    return {s, t, -slope * std::abs(s - 0.5)};
  });
  const auto on_roof = [&](double s, double t) -> Vector3d { return {s, t, -slope * std::abs(s - 0.5)}; };
  const Vector3d a = on_roof(0.21, 0.13), b = on_roof(0.62, 0.82);
  const Problem problem = between(
      roof, from_file(roof, TensorPlace::vertices, [](const Vector3d&) -> Matrix3d { return Matrix3d::Identity(); }), a,
      b);
  CoordinatePath chain{Points(3, 3), {-1, -1, -1}, false};
  chain.u << a, on_roof(0.21 + 0.41 * 0.2, 0.13 + 0.69 * 0.2), b;  // on the line of the unfolded roof
  roof->project(chain);
  std::vector<SurfacePoint> points = surface_points(roof->mesh(), chain);
  const double exact = std::hypot(u * 0.41, 0.69), cut = path_length(trace_chain(roof->mesh(), points).path);
  const FirstPath first = DijkstraInitializer().first_path(problem, {});
  const PostProcessed made = TracePostProcessor().apply(problem, first, as_delivered(problem, chain), {});
  CAPTURE(exact, cut, made.curve.cost);
  CHECK(cut > exact * 1.001);
  CHECK(made.curve.cost == Approx(exact).epsilon(1e-9));
  CHECK(made.curve_costs.sum() == Approx(made.curve.cost).epsilon(1e-12));
}

TEST_CASE("isophotic metric: a cylinder as a cloud", "[oracle]") {
  const double r = 0.5, w = 0.8, phi = 2, dz = 1.2, exact = std::hypot(dz, std::hypot(r, w) * phi);
  std::vector<double> errors;
  for (const int count : {2000, 8000}) {
    PointSamples samples;
    for (int i = 0; i < count; ++i) {
      const auto [s, t] = quasi_random(i);
      samples.positions.emplace_back(r * std::cos(4 * s - 1), r * std::sin(4 * s - 1), 3 * t - 0.9);
    }
    const auto cloud = std::make_shared<PointCloudManifold>(PointCloud(samples, {}));
    const Vector3d a(r, 0, 0), b(r * std::cos(phi), r * std::sin(phi), dz);
    const Result result = find(between(cloud, curvature(*cloud, w), a, b), 63, DijkstraInitializer());
    const Certificate& c = result.certificate;
    errors.push_back(c.estimate.value / exact - 1);
    CAPTURE(count, failures(c));
    REQUIRE(c.geometry_error);
    std::printf("isophotic cylinder, cloud of %d: relative error %.1e, geometry error %.1e\n", count, errors.back(),
                *c.geometry_error / exact);
    // The curvatures are estimated from the same samples: what they are off by is part of the geometry error.
    CHECK(std::abs(c.estimate.value - exact) <= c.estimate.error + *c.geometry_error);
  }
  CAPTURE(errors);
  CHECK(std::abs(errors[1]) < 0.01);
}

}  // namespace leastcost::test
