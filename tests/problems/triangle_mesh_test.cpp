// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/triangle_mesh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "problems/mesh/polygon_triangulation.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

using test::add_polygon;
using test::Closing;

constexpr unsigned kMeshSeed = 20260101;

Eigen::Vector3d random_barycentric(std::mt19937_64& engine) {
  std::exponential_distribution<double> exponential;
  const Eigen::Vector3d e(exponential(engine), exponential(engine), exponential(engine));
  return e / e.sum();
}

/// The same surface with about half of the faces turned round; `turned` says which.
PolygonSoup flip_some(PolygonSoup soup, std::mt19937_64& engine, std::vector<bool>& turned) {
  turned.clear();
  for (std::size_t p = 0; p + 1 < soup.polygon_begin.size(); ++p) {
    turned.push_back(engine() % 2 == 0);
    if (turned.back())
      std::reverse(soup.corners.begin() + soup.polygon_begin[p], soup.corners.begin() + soup.polygon_begin[p + 1]);
  }
  return soup;
}

void check_adjacency(const TriangleMesh& mesh) {
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t other = mesh.across(h);
    if (other < 0) continue;
    REQUIRE(mesh.across(other) == h);
    REQUIRE(other / 3 != h / 3);
    REQUIRE(std::minmax(mesh.tail(h), mesh.head(h)) == std::minmax(mesh.tail(other), mesh.head(other)));
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto around = mesh.neighbours(v);
    REQUIRE(std::is_sorted(around.begin(), around.end()));
    REQUIRE(std::adjacent_find(around.begin(), around.end()) == around.end());
    std::set<std::int32_t> expected;
    for (const std::int32_t f : mesh.faces_of_vertex(v)) expected.insert(mesh.face(f).begin(), mesh.face(f).end());
    REQUIRE(expected.erase(v) == 1);
    REQUIRE(std::equal(around.begin(), around.end(), expected.begin(), expected.end()));
  }
}

std::int32_t euler_characteristic(const TriangleMesh& mesh) {
  std::int32_t ends = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) ends += static_cast<std::int32_t>(mesh.neighbours(v).size());
  return mesh.vertex_count() - ends / 2 + mesh.face_count();
}

std::int32_t border_sides(const TriangleMesh& mesh) {
  std::int32_t count = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) count += mesh.across(h) == TriangleMesh::kBorder ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("mesh: Euler characteristics of surfaces of known genus", "[mesh]") {
  struct Sample {
    const char* name;
    PolygonSoup soup;
    std::int32_t euler, border, flipped_edges_at_least;
  };
  const std::vector<Sample> samples = {{"cube", test::cube(), 2, 0, 0},
                                       {"octahedron", test::octahedron(), 2, 0, 0},
                                       {"disc", test::grid(5, 4, Closing::kOpen, false), 1, 18, 0},
                                       {"annulus", test::grid(5, 4, Closing::kRound, false), 0, 10, 0},
                                       {"Moebius strip", test::grid(5, 4, Closing::kTwisted, false), 0, 10, 1},
                                       {"torus", test::grid(6, 5, Closing::kRound, true), 0, 0, 0},
                                       {"Klein bottle", test::grid(6, 5, Closing::kTwisted, true), 0, 0, 1}};
  for (const Sample& sample : samples) {
    for (const int levels : {0, 2}) {
      INFO(sample.name << ", subdivided " << levels << " times");
      const TriangleMesh mesh(sample.soup, {false, levels});
      check_adjacency(mesh);
      CHECK(euler_characteristic(mesh) == sample.euler);
      CHECK(border_sides(mesh) == sample.border << levels);
      CHECK(mesh.flipped_halfedges().size() >= 2u * static_cast<unsigned>(sample.flipped_edges_at_least));
      CHECK((sample.flipped_edges_at_least > 0 || mesh.flipped_halfedges().empty()));
      CHECK(mesh.non_manifold_edges().empty());
      CHECK(mesh.component_sizes() == std::vector<std::int32_t>{mesh.vertex_count()});
    }
  }
}

TEST_CASE("mesh: nothing but the side of normals depends on the order of corners", "[mesh]") {
  std::mt19937_64 engine(kMeshSeed);
  const PolygonSoup soup = test::soup_of(TriangleMesh(test::grid(12, 9, Closing::kRound, true)));
  std::vector<bool> turned;
  const TriangleMesh plain(soup), flipped(flip_some(soup, engine, turned));
  check_adjacency(flipped);
  for (std::int32_t v = 0; v < plain.vertex_count(); ++v) {
    const auto a = plain.neighbours(v), b = flipped.neighbours(v);
    CHECK(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    CHECK(plain.vertex_angle(v) == Approx(flipped.vertex_angle(v)).epsilon(1e-13));
    CHECK(plain.on_border(v) == flipped.on_border(v));
  }
  for (const std::int32_t h : flipped.flipped_halfedges()) {
    CHECK(turned[static_cast<std::size_t>(h / 3)] != turned[static_cast<std::size_t>(flipped.across(h) / 3)]);
  }
  for (std::int32_t f = 0; f < plain.face_count(); ++f) {
    const Eigen::Vector3d b = random_barycentric(engine);
    const bool is_turned = turned[static_cast<std::size_t>(f)];
    const Eigen::Vector3d same_place = is_turned ? Eigen::Vector3d(b.reverse()) : b;
    const Eigen::Vector3d expected = (is_turned ? -1.0 : 1.0) * plain.smooth_normal({f, b});
    CHECK((flipped.smooth_normal({f, same_place}) - expected).norm() < 1e-12);
  }
}

TEST_CASE("mesh: smooth normals converge to those of a sphere", "[mesh]") {
  std::mt19937_64 engine(kMeshSeed);
  std::vector<double> errors;
  for (const int levels : {3, 4, 5}) {
    const TriangleMesh mesh(test::sphere(levels));
    double worst = 0;
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      const SurfacePoint p{f, random_barycentric(engine)};
      CHECK(mesh.face_normal(f).dot(mesh.point(p)) > 0);
      worst = std::max(worst, (mesh.smooth_normal(p) - mesh.point(p).normalized()).norm());
    }
    errors.push_back(worst);
  }
  // Interpolation of vertex normals that are themselves at least first order in the edge length.
  CHECK(errors[1] < 0.6 * errors[0]);
  CHECK(errors[2] < 0.6 * errors[1]);
}

TEST_CASE("mesh: smooth normals are continuous across edges, up to the side, on a Moebius strip", "[mesh]") {
  const TriangleMesh mesh(test::grid(40, 6, Closing::kTwisted, false));
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t other = mesh.across(h);
    if (other < 0) continue;
    const bool same_direction = mesh.tail(h) == mesh.tail(other);
    const auto on_side = [&](std::int32_t side, double t) {
      Eigen::Vector3d b = Eigen::Vector3d::Zero();
      b[side % 3] = 1 - t;
      b[(side + 1) % 3] = t;
      return mesh.smooth_normal({side / 3, b});
    };
    const Eigen::Vector3d here = on_side(h, 0.3), there = on_side(other, same_direction ? 0.3 : 0.7);
    CHECK((here - (same_direction ? -1.0 : 1.0) * there).norm() < 1e-12);
    CHECK(here.norm() == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("mesh: a vertex where two sheets touch has a normal on each", "[mesh]") {
  // Two pyramids without base whose tips meet in vertex 0; their axes are x and -x.
  PolygonSoup soup;
  soup.positions.push_back(Eigen::Vector3d::Zero());
  for (const double side : {1.0, -1.0}) {
    for (int k = 0; k < 4; ++k) {
      const double angle = std::numbers::pi / 2 * k;
      soup.positions.emplace_back(side, std::cos(angle), std::sin(angle));
    }
    const std::int32_t first = side > 0 ? 1 : 5;
    for (int k = 0; k < 4; ++k) add_polygon(soup, {0, first + k, first + (k + 1) % 4});
  }
  const TriangleMesh mesh(soup);
  const Eigen::Vector3d tip(1, 0, 0);
  const Eigen::Vector3d first = mesh.smooth_normal({0, tip});
  const Eigen::Vector3d second = mesh.smooth_normal({4, tip});
  CHECK((first - Eigen::Vector3d(first.x() > 0 ? 1 : -1, 0, 0)).norm() < 1e-14);
  CHECK((second - Eigen::Vector3d(second.x() > 0 ? 1 : -1, 0, 0)).norm() < 1e-14);
  for (std::int32_t f = 1; f < 4; ++f) CHECK((mesh.smooth_normal({f, tip}) - first).norm() < 1e-14);
  CHECK(mesh.component_sizes() == std::vector<std::int32_t>{9});
}

TEST_CASE("mesh: three faces on an edge are no neighbours of each other", "[mesh]") {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  add_polygon(soup, {0, 1, 2});
  add_polygon(soup, {1, 0, 3});
  add_polygon(soup, {0, 1, 4});
  const TriangleMesh mesh(soup);
  for (const std::int32_t f : {0, 1, 2}) CHECK(mesh.across(3 * f) == TriangleMesh::kNonManifold);
  CHECK(mesh.non_manifold_edges() == std::vector<std::pair<std::int32_t, std::int32_t>>{{0, 1}});
  CHECK((mesh.smooth_normal({1, {0.4, 0.4, 0.2}}) - mesh.face_normal(1)).norm() < 1e-15);
}

TEST_CASE("mesh: cone angles", "[mesh]") {
  const TriangleMesh cube(test::cube(), {false, 2});
  for (std::int32_t v = 0; v < cube.vertex_count(); ++v) {
    const double expected = v < 8 ? 1.5 * std::numbers::pi : 2 * std::numbers::pi;
    CHECK(cube.vertex_angle(v) == Approx(expected).epsilon(1e-14));
    CHECK_FALSE(cube.on_border(v));
  }
}

TEST_CASE("mesh: subdivision keeps geometry, file numbers and addresses", "[mesh]") {
  std::mt19937_64 engine(kMeshSeed);
  const PolygonSoup soup = test::grid(7, 5, Closing::kTwisted, false);
  const TriangleMesh coarse(soup);
  for (const int levels : {1, 3}) {
    const TriangleMesh fine(soup, {false, levels});
    REQUIRE(fine.face_count() == coarse.face_count() << (2 * levels));
    CHECK(test::area_of(fine) == Approx(test::area_of(coarse)).epsilon(1e-12));
    CHECK(fine.diameter() == coarse.diameter());
    for (std::int32_t v = 0; v < coarse.vertex_count(); ++v) {
      CHECK(fine.vertex_of_file(v) == v);
      CHECK(fine.file_vertex(v) == v);
      CHECK(fine.position(v) == coarse.position(v));
    }
    CHECK(fine.file_vertex(fine.vertex_count() - 1) == -1);
    for (std::int32_t f = 0; f < fine.face_count(); ++f) {
      const SurfacePoint p{f, random_barycentric(engine)};
      const TriangleMesh::FilePoint in_file = fine.in_file(p);
      CHECK(in_file.face == fine.file_face(f));
      Eigen::Vector3d position = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        position +=
            in_file.barycentric[static_cast<int>(k)] * soup.positions[static_cast<std::size_t>(in_file.vertices[k])];
      CHECK((position - fine.point(p)).norm() < 1e-14 * fine.diameter());
      const SurfacePoint back = fine.locate(in_file);
      CHECK(back.face == f);
      CHECK((back.barycentric - p.barycentric).norm() < 1e-14);
      CHECK((coarse.point(coarse.locate(in_file)) - fine.point(p)).norm() < 1e-14 * fine.diameter());
      CHECK((fine.face_normal(f) - coarse.face_normal(coarse.locate(in_file).face)).norm() < 1e-12);
    }
  }
}

TEST_CASE("mesh: corners and edge middles of a file triangle are located exactly", "[mesh]") {
  const PolygonSoup soup = test::octahedron();
  const TriangleMesh fine(soup, {false, 3});
  for (std::int32_t f = 0; f < 8; ++f) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t corner = static_cast<std::size_t>(soup.corners[static_cast<std::size_t>(3 * f + k)]);
      CHECK(fine.point(fine.locate(f, Eigen::Vector3d::Unit(k))) == soup.positions[corner]);
    }
    const SurfacePoint middle = fine.locate(f, {0.5, 0.5, 0});
    CHECK(middle.barycentric.maxCoeff() == 1);
  }
}

TEST_CASE("mesh: welding closes a cube whose faces share no vertices", "[mesh]") {
  const PolygonSoup cube = test::cube();
  PolygonSoup soup;
  for (std::size_t p = 0; p < 6; ++p) {
    const std::int32_t first = static_cast<std::int32_t>(soup.positions.size());
    for (std::size_t k = 0; k < 4; ++k)
      soup.positions.push_back(cube.positions[static_cast<std::size_t>(cube.corners[4 * p + k])]);
    add_polygon(soup, {first, first + 1, first + 2, first + 3});
  }
  soup.positions.emplace_back(7, 7, 7);
  const TriangleMesh loose(soup), welded(soup, {true, 0});
  CHECK(loose.component_sizes().size() == 6);
  CHECK(loose.vertex_of_file(24) == -1);
  CHECK(welded.vertex_count() == 8);
  CHECK(euler_characteristic(welded) == 2);
  CHECK(border_sides(welded) == 0);
  CHECK(welded.vertex_of_file(24) == -1);
  CHECK(welded.file_vertex_count() == 25);
  for (std::int32_t v = 0; v < 24; ++v)
    CHECK(welded.position(welded.vertex_of_file(v)) == soup.positions[static_cast<std::size_t>(v)]);
  CHECK_THROWS_AS(welded.vertex_of_file(25), InputError);
  CHECK_THROWS_AS(welded.vertex_of_file(-1), InputError);
}

TEST_CASE("mesh: welding within a distance closes a soup that rounding has opened, and moves nothing farther",
          "[mesh]") {
  test::Random random(5);
  const PolygonSoup cube = test::cube();
  for (const double place : {0.0, 1e6}) {
    PolygonSoup soup;
    for (std::size_t p = 0; p < 6; ++p) {
      const std::int32_t first = static_cast<std::int32_t>(soup.positions.size());
      for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector3d corner = cube.positions[static_cast<std::size_t>(cube.corners[4 * p + k])];
        soup.positions.emplace_back(corner + Eigen::Vector3d::Constant(place) +
                                    Eigen::Vector3d(random.uniform(-1e-7, 1e-7), random.uniform(-1e-7, 1e-7), 0));
      }
      add_polygon(soup, {first, first + 1, first + 2, first + 3});
    }
    CHECK(TriangleMesh(soup, {.weld = true}).vertex_count() > 8);
    const TriangleMesh joined(soup, {.weld_within = 1e-6});
    CHECK(joined.vertex_count() == 8);
    CHECK(euler_characteristic(joined) == 2);
    CHECK(border_sides(joined) == 0);
    for (std::int32_t v = 0; v < 24; ++v)
      CHECK((joined.position(joined.vertex_of_file(v)) - soup.positions[static_cast<std::size_t>(v)]).norm() <= 1e-6);
  }
  for (const double within : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    CHECK_THROWS_AS(TriangleMesh(cube, {.weld_within = within}), OptionError);
}

TEST_CASE("mesh: vertices that stand in a row are not all drawn into one by a weld", "[mesh]") {
  PolygonSoup soup;
  for (int k = 0; k < 20; ++k) {  // a strip, its corners 0.6 apart
    soup.positions.emplace_back(0.6 * k, 0, 0);
    soup.positions.emplace_back(0.6 * k, 5, 0);
  }
  for (std::int32_t k = 0; k + 1 < 20; ++k) add_polygon(soup, {2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
  const TriangleMesh mesh(soup, {.weld_within = 1});
  CHECK(mesh.vertex_count() == 20);  // every second pair
  for (std::int32_t v = 0; v < 40; ++v)
    CHECK((mesh.position(mesh.vertex_of_file(v)) - soup.positions[static_cast<std::size_t>(v)]).norm() <= 1);
}

TEST_CASE("mesh: polygons of every shape are cut inside", "[mesh]") {
  struct Sample {
    const char* name;
    std::vector<Eigen::Vector2d> corners;
  };
  const std::vector<Sample> samples = {
      {"arrow, notch first", {{0, 1}, {-2, 0}, {0, 4}, {2, 0}}},
      {"arrow, notch second", {{2, 0}, {0, 1}, {-2, 0}, {0, 4}}},
      {"quad with a straight corner", {{0, 0}, {1, 0}, {2, 0}, {0, 2}}},
      {"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},
      {"comb", {{0, 0}, {7, 0}, {7, 3}, {6, 1}, {5, 3}, {4, 1}, {3, 3}, {2, 1}, {1, 3}}},
      {"spiral",
       {{0, 0},
        {6, 0},
        {6, 6},
        {1, 6},
        {1, 2},
        {4, 2},
        {4, 4},
        {3, 4},
        {3, 3},
        {2, 3},
        {2, 5},
        {5, 5},
        {5, 1},
        {0, 1}}},
      {"triangle with points on its sides", {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 1}, {1, 2}, {0, 3}, {0, 1}}},
      {"frame with a slit", {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}}};
  const Eigen::AngleAxisd tilt(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  for (const Sample& sample : samples) {
    INFO(sample.name);
    std::vector<Eigen::Vector3d> corners;
    double area = 0;
    for (std::size_t i = 0; i < sample.corners.size(); ++i) {
      const Eigen::Vector2d& p = sample.corners[i];
      const Eigen::Vector2d& q = sample.corners[(i + 1) % sample.corners.size()];
      area += 0.5 * (p.x() * q.y() - p.y() * q.x());
      corners.push_back(tilt * Eigen::Vector3d(p.x(), p.y(), 5));
    }
    const Triangulation result = triangulate_polygon(corners);
    CHECK(result.simple);
    CHECK(result.triangles.size() == corners.size() - 2);
    double sum = 0;
    for (const auto& [a, b, c] : result.triangles) {
      const Eigen::Vector3d& at = corners[static_cast<std::size_t>(a)];
      const Eigen::Vector3d normal =
          (corners[static_cast<std::size_t>(b)] - at).cross(corners[static_cast<std::size_t>(c)] - at);
      CHECK(normal.dot(tilt * Eigen::Vector3d::UnitZ()) * (area > 0 ? 1 : -1) > -1e-12);
      sum += 0.5 * normal.norm();
    }
    // Equal areas and no triangle turned over: no overlap, nothing outside.
    CHECK(sum == Approx(std::abs(area)).epsilon(1e-12));
  }
}

TEST_CASE("mesh: random star-shaped polygons are cut without overlap", "[mesh]") {
  std::mt19937_64 engine(kMeshSeed);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (int round = 0; round < 200; ++round) {
    const int count = 4 + round;
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < count; ++i) {
      const double r = radius(engine), angle = 2 * std::numbers::pi * i / count;
      corners.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) area += 0.5 * corners[i].cross(corners[(i + 1) % corners.size()]);
    const Triangulation result = triangulate_polygon(corners);
    CHECK(result.simple);
    double sum = 0;
    for (const auto& [a, b, c] : result.triangles) {
      const Eigen::Vector3d& at = corners[static_cast<std::size_t>(a)];
      sum += 0.5 * (corners[static_cast<std::size_t>(b)] - at).cross(corners[static_cast<std::size_t>(c)] - at).norm();
    }
    CHECK(sum == Approx(area.z()).epsilon(1e-12));
  }
}

TEST_CASE("mesh: polygons are noted, addressed by their triangles, and need a name beyond coordinates", "[mesh]") {
  const TriangleMesh mesh(test::cube(), {false, 1});
  CHECK(mesh.face_count() == 48);
  CHECK(mesh.file_face_count() == 6);
  REQUIRE(mesh.notes().size() == 1);
  CHECK(mesh.notes()[0] == "6 polygons cut into 12 triangles");
  CHECK_THROWS_AS(mesh.locate(2, {1, 0, 0}), InputError);
  CHECK_THROWS_AS(mesh.locate(TriangleMesh::FilePoint{2, 2, {}, {1, 0, 0}}), InputError);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) CHECK(mesh.file_face(f) == f / 8);
}

TEST_CASE("mesh: degenerate polygons are reduced or left out, and said", "[mesh]") {
  PolygonSoup soup = test::octahedron();
  add_polygon(soup, {0, 2, 2});
  add_polygon(soup, {0, 0, 0, 0, 0});
  // A quad with a repeated corner is a triangle: leaving it out would tear a hole.
  soup.corners.insert(soup.corners.begin() + 3, soup.corners[2]);
  for (std::size_t p = 1; p < soup.polygon_begin.size(); ++p) ++soup.polygon_begin[p];
  const TriangleMesh mesh(soup);
  CHECK(mesh.face_count() == 8);
  CHECK(euler_characteristic(mesh) == 2);
  REQUIRE(mesh.notes().size() == 1);
  CHECK(mesh.notes()[0] == "2 degenerate faces left out (fewer than three different corners)");
  CHECK_THROWS_AS(mesh.locate(8, {1, 0, 0}), InputError);
  CHECK(mesh.point(mesh.locate(0, {0, 0, 1})) == soup.positions[4]);
}

TEST_CASE("mesh: polygons that cross themselves are cut and reported", "[mesh]") {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}, {0, 2, 0}};
  add_polygon(soup, {0, 1, 2, 3});
  add_polygon(soup, {0, 1, 2, 4});
  const TriangleMesh mesh(soup);
  CHECK(mesh.face_count() == 4);
  REQUIRE(mesh.notes().size() == 2);
  CHECK(mesh.notes()[1] == "2 polygons intersected themselves, so some triangles overlap");
}

TEST_CASE("mesh: a large polygon that is not convex is refused rather than cut for hours", "[mesh]") {
  PolygonSoup soup;
  soup.polygon_begin = {0};
  const int count = 30001;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count, r = i % 2 == 0 ? 1 : 0.9;
    soup.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    soup.corners.push_back(i);
  }
  soup.polygon_begin.push_back(count);
  CHECK_THROWS_AS(TriangleMesh(soup), InputError);
}

TEST_CASE("mesh: what cannot be a mesh is refused with a reason", "[mesh]") {
  const auto message_of = [](const PolygonSoup& soup) -> std::string {
    try {
      const TriangleMesh mesh(soup);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto mentions = [](const std::string& text) { return Catch::Matchers::Contains(text); };
  PolygonSoup bad = test::octahedron();
  bad.source = "ball.obj";
  bad.corners[4] = 6;
  CHECK_THAT(message_of(bad), mentions("ball.obj: face 1 uses vertex 6"));
  bad.corners[4] = -1;
  CHECK_THAT(message_of(bad), mentions("face 1 uses vertex -1"));
  bad = test::octahedron();
  bad.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(message_of(bad), mentions("vertex 3"));
  bad.positions[3].y() = 1e80;
  CHECK_THAT(message_of(bad), mentions("vertex 3"));
  bad = test::octahedron();
  bad.polygon_begin.pop_back();
  CHECK_THAT(message_of(bad), mentions("polygon_begin"));
  bad = test::octahedron();
  bad.polygon_begin[3] = bad.polygon_begin[2] + 2;
  CHECK_THAT(message_of(bad), mentions("fewer than 3 corners"));
  bad.corners.assign(bad.corners.size(), 0);
  bad.polygon_begin = {0, 3, 6, 24};
  CHECK_THAT(message_of(bad), mentions("no face with three different corners"));
  CHECK_THAT(message_of(PolygonSoup{}), mentions("no faces"));
  const TriangleMesh mesh(test::octahedron());
  for (const Eigen::Vector3d& b :
       {Eigen::Vector3d(0.5, 0.6, 0), Eigen::Vector3d(-0.1, 0.6, 0.5), Eigen::Vector3d(1, NAN, 0)}) {
    CHECK_THROWS_AS(mesh.locate(0, b), InputError);
  }
  CHECK_THROWS_AS(mesh.locate(8, {1, 0, 0}), InputError);
  CHECK_THROWS_AS(mesh.locate(-1, {1, 0, 0}), InputError);
  CHECK_THROWS_AS(TriangleMesh(test::octahedron(), {false, -1}), OptionError);
  CHECK_THROWS_AS(TriangleMesh(test::octahedron(), {false, 14}), OptionError);
}

TEST_CASE("mesh: barycentric coordinates with three digits are taken as meant", "[mesh]") {
  const TriangleMesh mesh(test::octahedron(), {false, 2});
  const SurfacePoint p = mesh.locate(0, {0.3333333, 0.3333333, 0.3333333});
  CHECK(p.barycentric.sum() == Approx(1).epsilon(1e-15));
  CHECK((mesh.point(p) - Eigen::Vector3d::Constant(1.0 / 3)).norm() < 1e-7);
}

TEST_CASE("mesh: tiny and huge units work alike", "[mesh]") {
  for (const double unit : {1e-60, 1e60}) {
    PolygonSoup soup = test::sphere(2);
    for (Eigen::Vector3d& p : soup.positions) p *= unit;
    const TriangleMesh mesh(soup), reference(test::sphere(2));
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      CHECK((mesh.smooth_normal({f, {0.2, 0.3, 0.5}}) - reference.smooth_normal({f, {0.2, 0.3, 0.5}})).norm() < 1e-12);
    }
  }
}

TEST_CASE("mesh: adjacency and addresses hold on a real mesh", "[mesh]") {
  const auto file = test::data_file("meshes/bunny_holes_69k.obj");
  if (!file) return;
  const TriangleMesh mesh(read_mesh(*file));
  check_adjacency(mesh);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) REQUIRE(mesh.vertex_of_file(mesh.file_vertex(v)) == v);
  std::int32_t unused = 0;
  for (std::int32_t v = 0; v < mesh.file_vertex_count(); ++v) unused += mesh.vertex_of_file(v) < 0 ? 1 : 0;
  CHECK(unused == 1113);  // MANIFEST.md
  // Gauss and Bonnet: the angle defects of a surface make 2 pi times its Euler characteristic.
  double defect = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    defect += (mesh.on_border(v) ? 1 : 2) * std::numbers::pi - mesh.vertex_angle(v);
  }
  CHECK(defect == Approx(2 * std::numbers::pi * euler_characteristic(mesh)).epsilon(1e-9));
}

TEST_CASE("mesh: data so small that squares of lengths vanish is refused, as data that is too large") {
  const auto square = [](double size) {
    PolygonSoup soup;
    soup.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    add_polygon(soup, {0, 1, 2, 3});
    return soup;
  };
  CHECK(TriangleMesh(square(1e-74)).diameter() == Approx(std::sqrt(2) * 1e-74).epsilon(1e-14));
  for (const double size : {1e-76, 1e-170, 1e-300})
    CHECK_THROWS_WITH(TriangleMesh(square(size)), Catch::Contains("below 1e-75") && Catch::Contains("sensible units"));
  CHECK_THROWS_WITH(TriangleMesh(square(1e76)), Catch::Contains("beyond 1e75"));
}

}  // namespace leastcost
