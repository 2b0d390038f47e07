// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Distances sampled from meshes, implicit surfaces and clouds, and the grids made of them.
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/distance/build_distance_grid.hpp>
#include "problems/distance/cloud_distance.hpp"
#include "problems/distance/implicit_distance.hpp"
#include "problems/distance/mesh_distance.hpp"
#include "problems/level_set/formula_constraint.hpp"
#include "problems/level_set/named_surfaces.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;

Eigen::AlignedBox3d cube_box(double half) { return {Vector3d::Constant(-half), Vector3d::Constant(half)}; }

std::shared_ptr<const DistanceSource> implicit_sphere(double radius = 1) {
  return make_implicit_distance(make_sphere_function(3, radius), cube_box(radius));
}
std::shared_ptr<const DistanceSource> formula(const char* f, double half) {
  return make_implicit_distance(make_formula_constraint(formulas_of_option("f", {f}, {"x", "y", "z"}, {})),
                                cube_box(half));
}
std::shared_ptr<const DistanceSource> mesh_source(const PolygonSoup& soup, bool sides = true) {
  return make_mesh_distance(TriangleMesh(soup), sides);
}

/// Largest difference between the samples of a source and a distance, up to `band` from the surface.
template <class Distance>
double worst_difference(const DistanceSource& source, const GridShape& shape, double band, Distance distance) {
  const std::vector<double> values = source.sample(shape, band, {});
  double worst = 0;
  for (int k = 0; k < shape.count[2]; ++k)
    for (int j = 0; j < shape.count[1]; ++j)
      for (int i = 0; i < shape.count[0]; ++i) {
        const double d = distance(shape.node(i, j, k));
        if (std::abs(d) <= band) worst = std::max(worst, std::abs(values[shape.index(i, j, k)] - d));
      }
  return worst;
}

double off_cube(const Vector3d& x) {  // [-1/2, 1/2]^3
  const Vector3d q = x.cwiseAbs().array() - 0.5;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}

template <class Make>
std::string refusal_of(Make make) {
  try {
    make();
    return "accepted";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("distance of a mesh: exact near it, right to a hundredth of a cell elsewhere, signs everywhere") {
  const auto source = mesh_source(cube());
  const GridShape shape = grid_around(source->box(), 0.06, 10, 1e9);
  CHECK(worst_difference(*source, shape, 4 * shape.cell, off_cube) <= 1e-15);
  const std::vector<double> values = source->sample(shape, 4 * shape.cell, {});
  for (int k = 0; k < shape.count[2]; ++k)
    for (int j = 0; j < shape.count[1]; ++j)
      for (int i = 0; i < shape.count[0]; ++i)
        CHECK(std::abs(values[shape.index(i, j, k)] - off_cube(shape.node(i, j, k))) <= 0.01 * shape.cell);
}

TEST_CASE("distance of a mesh: inside out, mixed up, a cavity, parts that overlap are refused") {
  const TriangleMesh ball{sphere(3)};
  const auto with = [&](auto&& change) {
    PolygonSoup soup = soup_of(ball);
    change(soup);
    return build_distance_grid(*mesh_source(soup), {.cell = 0.1});
  };
  const auto turn = [](PolygonSoup& soup, std::size_t f) { std::swap(soup.corners[3 * f], soup.corners[3 * f + 1]); };
  Vector3d gradient;
  const auto all = with([&](PolygonSoup& s) {
    for (std::size_t f = 0; f < s.corners.size() / 3; ++f) turn(s, f);
  });
  CHECK(all.grid.evaluate(Vector3d(0.9, 0, 0), gradient) == Approx(-0.1).margin(0.01));
  const auto some = with([&](PolygonSoup& s) {
    for (std::size_t f = 0; f < s.corners.size() / 3; f += 5) turn(s, f);
  });
  CHECK(some.grid.evaluate(Vector3d(0.9, 0, 0), gradient) == Approx(-0.1).margin(0.01));
  CHECK_THAT(some.notes.front(), Catch::Contains("faces turned"));
  const auto added = [&](double scale, const Vector3d& shift, bool inwards) {
    return with([&](PolygonSoup& s) {
      const auto first = static_cast<std::int32_t>(s.positions.size());
      for (const Vector3d& p : ball.positions()) s.positions.emplace_back(scale * p + shift);
      for (const auto& [a, b, c] : ball.faces()) {
        if (inwards)
          add_polygon(s, {first + b, first + a, first + c});
        else
          add_polygon(s, {first + a, first + b, first + c});
      }
    });
  };
  const Vector3d centre = Vector3d::Zero(), between(0.75, 0, 0);
  const auto shell = added(0.5, centre, true);
  CHECK(shell.grid.evaluate(centre, gradient) > 0.3);  // a cavity
  CHECK(shell.grid.evaluate(between, gradient) < -0.2);
  CHECK_THAT(refusal_of([&] { added(1, Vector3d(1, 0, 0), false); }), Catch::Contains("parts inside others"));
}

TEST_CASE("distance of a mesh: what has no inside is refused with the place, or taken without sides") {
  PolygonSoup open;
  const TriangleMesh ball{sphere(3)};
  open.positions = ball.positions();
  for (std::int32_t f = 1; f < ball.face_count(); ++f)
    add_polygon(open, {ball.face(f)[0], ball.face(f)[1], ball.face(f)[2]});
  CHECK_THAT(refusal_of([&] { mesh_source(open); }),
             Catch::Contains("3 border edges in 1 loops") && Catch::Contains("sign: unsigned"));
  // Every triangle with corners of its own, as STL has them: what the message names helps.
  PolygonSoup apart;
  for (const auto& [a, b, c] : ball.faces()) {
    for (const int v : {a, b, c}) apart.positions.push_back(ball.position(v));
    const int n = static_cast<int>(apart.positions.size());
    add_polygon(apart, {n - 3, n - 2, n - 1});
  }
  CHECK_THAT(refusal_of([&] { mesh_source(apart); }),
             Catch::Contains("`weld: true` merges vertices at equal positions"));
  CHECK_NOTHROW(make_mesh_distance(TriangleMesh(apart, {true}), true));
  CHECK_THAT(refusal_of([&] { mesh_source(grid(12, 12, Closing::kTwisted, true)); }), Catch::Contains("one-sided"));
  const SampledDistance around = build_distance_grid(*mesh_source(open, false), {.cell = 0.08, .offset = 0.3});
  Vector3d gradient;
  for (const Vector3d& x : {Vector3d(0, 1.3, 0), Vector3d(0, -0.7, 0)})
    CHECK(around.grid.evaluate(x, gradient) ==
          Approx(0).margin(0.01));  // the surface itself is up to 0.005 inside the sphere
  CHECK_THAT(refusal_of([&] { build_distance_grid(*mesh_source(open, false), {.cell = 0.2, .offset = 0.3}); }),
             Catch::Contains("at least 3 cells"));
}

TEST_CASE("distance of an implicit surface: exact within the band, whatever the scale") {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const auto source = implicit_sphere(scale);
    const GridShape shape = grid_around(source->box(), 0.13 * scale, 6, 1e9);
    CHECK(worst_difference(*source, shape, 0.8 * scale, [&](const Vector3d& x) { return x.norm() - scale; }) <=
          1e-9 * scale);
  }
  // f is far from a distance here: 0.1 to 40 times one.
  const auto torus = formula("(x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2)", 3);
  const GridShape shape = grid_around(torus->box(), 0.2, 3, 1e9);
  const auto off = [](const Vector3d& x) { return std::hypot(std::hypot(x[0], x[1]) - 2, x[2]) - 1; };
  CHECK(worst_difference(*torus, shape, 0.7, off) <= 1e-8);
}

TEST_CASE("distance of an implicit surface: no zero, a pole, no value") {
  const auto message = [](const char* f) {
    return refusal_of([&] { build_distance_grid(*formula(f, 1), {.cell = 0.1}); });
  };
  CHECK(message("x^2 + y^2 + z^2 - 1/2") == "accepted");
  CHECK_THAT(message("x^2 + y^2 + z^2 + 1"), Catch::Contains("no zero of f"));
  CHECK_THAT(message("x^2 + y^2 + z^2 - 100"), Catch::Contains("no zero of f"));
  CHECK_THAT(message("(x^2 + y^2 + z^2 - 1/2)/(x - 0.01)"), Catch::Contains("changes its sign near"));
  CHECK_THAT(message("log(x + 1.2) + y"), Catch::Contains("no finite value"));
}

TEST_CASE("distance of a cloud: that of its surface, signed by its normals") {
  const auto source = make_cloud_distance(PointCloud(sphere_cloud(1500, Vector3d(5, 0, 0)), {}), true);
  const GridShape shape = grid_around(source->box(), 0.12, 8, 1e9);
  // The surface itself is off the sphere by about the third power of the spacing, 0.09.
  CHECK(worst_difference(*source, shape, 0.2, [](const Vector3d& x) { return (x - Vector3d(5, 0, 0)).norm() - 1; }) <=
        1e-3);
}

TEST_CASE("distance of a cloud: an open one is refused, or taken without sides", "[slow_sanitized]") {
  PointSamples half;
  for (const Vector3d& p : sphere_cloud(1500).positions)
    if (p.z() > -0.3) half.positions.push_back(p);
  const PointCloud cloud(std::move(half), {});
  const auto build = [&](bool sides, double offset) {
    PointSamples again;
    for (const CloudSample& s : cloud.samples()) again.positions.emplace_back(s.position + cloud.centre());
    return build_distance_grid(*make_cloud_distance(PointCloud(std::move(again), {}), sides),
                               {.cell = 0.15, .offset = offset});
  };
  CHECK_THAT(refusal_of([&] { build(true, 0); }), Catch::Contains("has no inside"));
  Vector3d gradient;
  CHECK(build(false, 0.5).grid.evaluate(Vector3d(0, 0, 1.5), gradient) == Approx(0).margin(1e-2));
}

// A spline of a smooth function is of order 4, and the accuracy that was asked for is that of a sphere that is known.
TEST_CASE("building a grid: the miss is measured, and an accuracy is reached", "[slow_sanitized]") {
  double last = 0;
  for (const double cell : {0.2, 0.1, 0.05}) {
    const SampledDistance built = build_distance_grid(*implicit_sphere(), {.cell = cell});
    double worst = 0;
    Random random;
    for (int i = 0; i < 300; ++i) {
      Vector3d gradient;
      worst = std::max(worst, std::abs(built.grid.evaluate(random.vector(3).normalized(), gradient)));
    }
    CHECK(worst <= 1.5 * built.worst);
    if (last > 0) CHECK(std::log2(last / built.worst) > 3.5);
    last = built.worst;
  }
  for (const double scale : {1e-2, 1.0, 1e3}) {
    const SampledDistance built = build_distance_grid(*implicit_sphere(scale), {.accuracy = 2e-6 * scale});
    CHECK(built.worst <= 2e-6 * scale);
    CHECK(built.grid.shape().cell > 0.03 * scale);  // not far more than needed: 0.1 gives 1.6e-6
  }
  CHECK_THAT(refusal_of([] { build_distance_grid(*implicit_sphere(), {.accuracy = 1e-9, .memory = 1e7}); }),
             Catch::Contains("cannot be reached") && Catch::Contains("memory limit"));
}

TEST_CASE("building a grid: sheets thinner than a cell are noticed, as is a cell larger than the model") {
  PolygonSoup plate = cube();
  for (Vector3d& p : plate.positions) p.z() *= 0.02;
  CHECK_THAT(refusal_of([&] { build_distance_grid(*mesh_source(plate), {.cell = 0.1}); }),
             Catch::Contains("too large for this surface"));
  CHECK(build_distance_grid(*mesh_source(plate), {.cell = 0.008}).worst < 0.004);
  CHECK_THAT(refusal_of([&] { build_distance_grid(*mesh_source(cube()), {.cell = 3}); }), Catch::Contains("cell"));
  CHECK_THAT(refusal_of([&] { build_distance_grid(*implicit_sphere(), {.cell = 5}); }), Catch::Contains("cell"));
}

TEST_CASE("building a grid: options that cannot work, and stopping") {
  const auto key = [](const DistanceGridSettings& settings) -> std::string {
    try {
      build_distance_grid(*implicit_sphere(), settings);
    } catch (const OptionError& error) {
      return error.key();
    }
    return "accepted";
  };
  CHECK(key({.cell = -1}) == "cell");
  CHECK(key({.cell = 0}) == "cell");
  CHECK(key({.accuracy = -1}) == "accuracy");
  CHECK(key({.cell = 0.1, .accuracy = 0.1}) == "accuracy");
  CHECK(key({.margin = 0}) == "margin");
  CHECK(key({.cell = 0.2, .margin = 1}) == "accepted");
  struct Stop {};
  int calls = 0;
  const auto stop = [&](double part, std::string_view) {
    CHECK((part >= 0 && part <= 1));
    if (++calls == 5) throw Stop();
  };
  CHECK_THROWS_AS(build_distance_grid(*implicit_sphere(), {.cell = 0.1}, stop), Stop);
}

}  // namespace leastcost::test
