// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/mesh_report.hpp>

#include <numbers>
#include <numeric>

#include <leastcost/problems/readers/mesh_reader.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost {
namespace {

using test::add_polygon;
using test::Closing;

/// A row of data/MANIFEST.md, counted by another program. Genus is summed over components; -1: undefined.
struct Row {
  const char* file;
  std::int32_t vertices, faces;
  std::size_t components;
  std::int32_t genus, loops, non_manifold_edges, non_manifold_vertices, flipped_edges;
  double min_angle;  // degrees, two digits
};

constexpr Row kClean[] = {{"duck.obj", 2108, 4212, 1, 0, 0, 0, 0, 0, 3.7},
                          {"spot.obj", 2930, 5856, 1, 0, 0, 0, 0, 0, 10},
                          {"bunny_3k.off", 3485, 6966, 1, 0, 0, 0, 0, 0, 2.7},
                          {"bunny_70k.obj", 34835, 69666, 1, 0, 0, 0, 0, 0, 0.0068},
                          {"bunny_holes_69k.obj", 35947 - 1113, 69451, 1, 0, 5, 0, 0, 0, 0.48},
                          {"cow.off", 2762, 5520, 1, 0, 0, 0, 0, 0, 2.8},
                          {"fandisk.off", 6475, 12946, 1, 0, 0, 0, 0, 0, 17},
                          {"rocker-arm.obj", 10044, 20088, 1, 1, 0, 0, 0, 0, 2.6},
                          {"armadillo_52k.off", 26002, 52000, 1, 0, 0, 0, 0, 0, 4.5},
                          {"elephant.off", 2775, 5558, 1, 3, 0, 0, 0, 0, 30},
                          {"double-torus_tri.off", 231, 466, 1, 2, 0, 0, 0, 0, 0.082},
                          {"knot1.off", 3200, 6400, 1, 1, 0, 0, 0, 0, 25},
                          {"anchor_dense.off", 3793, 7598, 1, 4, 0, 0, 0, 0, 0.0007},
                          {"lion.off", 7529, 14859, 1, 0, 5, 0, 0, 0, 4.8},
                          {"camelhead.off", 11381, 22704, 1, 0, 1, 0, 0, 0, 0.55},
                          {"face.obj", 25905, 51712, 1, 0, 1, 0, 0, 0, 5.5},
                          {"mountain.obj", 25600, 50562, 1, 0, 1, 0, 0, 0, 11},
                          {"phobos.obj", 15581, 31158, 1, 0, 0, 0, 0, 0, 1},
                          {"dragon_871k.ply", 437645, 871414, 151, 46, 407, 0, 0, 0, 0}};

constexpr Row kDirty[] = {{"dragon_48k_dirty.ply", 22998 - 16, 47794, 1, -1, 0, 2094, 5, 0, 0.54},
                          {"horse_dirty.obj", 3582, 7172, 1, -1, 0, 24, 0, 2, 1.4},
                          {"teapot_dirty.obj", 3644, 6320, 4, -1, 10, 0, 38, 0, 3.4},
                          {"suzanne_quads.obj", 507, 968, 3, -1, 4, 1, 0, 0, 7.2},
                          {"wuson_dirty.off", 3205, 3732, 179, -1, 187, 0, 12, 0, 3.3},
                          {"blobby_shuffled.off", 2027, 4050, 1, 0, 0, 0, 0, 3069, 30},
                          {"polygon_mesh.off", 16344, 32245, 1, -1, 14, 0, 2, 0, 0.55},
                          {"fan3.obj", 5, 3, 1, -1, 1, 1, 0, 0, 40},
                          {"hourglass.obj", 23, 40, 1, -1, 0, 0, 1, 0, 60},
                          {"moebius.obj", 280, 448, 1, 1, 1, 0, 0, 4, 14}};

std::optional<MeshReport> report_of(const std::string& name, const MeshOptions& options = {}) {
  const auto file = test::data_file("meshes/" + name);
  if (!file) return std::nullopt;
  return inspect(TriangleMesh(read_mesh(*file), options));
}

/// Sum over the components, -1 when one has none.
std::int32_t genus_of(const MeshReport& report) {
  std::int32_t sum = 0;
  for (const MeshReport::Component& c : report.components) {
    if (!c.genus) return -1;
    sum += *c.genus;
  }
  return sum;
}

void check_row(const Row& row) {
  const std::optional<MeshReport> found = report_of(row.file);
  if (!found) return;
  const MeshReport& report = *found;
  INFO(row.file);
  CHECK(report.vertices == row.vertices);
  CHECK(report.faces == row.faces);
  CHECK(report.components.size() == row.components);
  CHECK(genus_of(report) == row.genus);
  CHECK(report.boundary_loops == row.loops);
  CHECK(report.non_manifold_edges == row.non_manifold_edges);
  CHECK(report.non_manifold_vertices == row.non_manifold_vertices);
  CHECK(report.flipped_edges == row.flipped_edges);
  CHECK(report.min_angle * 180 / std::numbers::pi == Approx(row.min_angle).epsilon(0.08).margin(1e-9));
}

}  // namespace

TEST_CASE("mesh report: surfaces of known genus", "[mesh_report]") {
  struct Sample {
    const char* name;
    PolygonSoup soup;
    std::int32_t genus, loops;
    bool orientable;
  };
  const std::vector<Sample> samples = {{"cube", test::cube(), 0, 0, true},
                                       {"disc", test::grid(5, 4, Closing::kOpen, false), 0, 1, true},
                                       {"annulus", test::grid(5, 4, Closing::kRound, false), 0, 2, true},
                                       {"Moebius strip", test::grid(5, 4, Closing::kTwisted, false), 1, 1, false},
                                       {"torus", test::grid(6, 5, Closing::kRound, true), 1, 0, true},
                                       {"Klein bottle", test::grid(6, 5, Closing::kTwisted, true), 2, 0, false}};
  for (const Sample& sample : samples) {
    for (const int levels : {0, 1}) {
      INFO(sample.name);
      const MeshReport report = inspect(TriangleMesh(sample.soup, {false, levels}));
      REQUIRE(report.components.size() == 1);
      CHECK(report.components[0].manifold);
      CHECK(report.components[0].genus == sample.genus);
      CHECK(report.boundary_loops == sample.loops);
      CHECK(report.orientable == sample.orientable);
      CHECK(report.components[0].orientable == sample.orientable);
      CHECK((sample.orientable || report.flipped_edges > 0));
    }
  }
}

TEST_CASE("mesh report: lengths, angles and area of a cube", "[mesh_report]") {
  const MeshReport report = inspect(TriangleMesh(test::cube()));
  CHECK(report.area == Approx(6).epsilon(1e-15));
  CHECK(report.min_angle == Approx(std::numbers::pi / 4).epsilon(1e-14));
  CHECK(report.min_edge == 1);
  CHECK(report.max_edge == Approx(std::numbers::sqrt2).epsilon(1e-15));
  CHECK(report.edges == 18);
}

TEST_CASE("mesh report: every fault is counted and named by the file's numbers", "[mesh_report]") {
  PolygonSoup soup;
  soup.positions.emplace_back(9, 9, 9);  // 0: in no face, so that our numbers are not those of the file
  for (const Eigen::Vector3d& p : test::cube().positions) soup.positions.push_back(p);
  const PolygonSoup cube = test::cube();
  for (std::size_t q = 0; q < 6; ++q) {
    add_polygon(soup, {cube.corners[4 * q] + 1, cube.corners[4 * q + 1] + 1, cube.corners[4 * q + 2] + 1,
                       cube.corners[4 * q + 3] + 1});
  }
  std::swap(soup.corners[0], soup.corners[2]);  // face 0 flipped
  soup.positions.emplace_back(2, 2, 2);         // 9 and 10 at the same place
  soup.positions.emplace_back(2, 2, 2);
  soup.positions.emplace_back(3, 3, 3);  // 11: on a line with 9 and 12
  soup.positions.emplace_back(4, 4, 4);
  add_polygon(soup, {9, 11, 12});        // face 6: no area
  soup.positions.emplace_back(5, 0, 0);  // 13, 14
  soup.positions.emplace_back(5, 1, 0);
  add_polygon(soup, {10, 13, 14});       // face 7
  add_polygon(soup, {14, 13, 10});       // face 8: face 7 again
  soup.positions.emplace_back(0, 0, 3);  // 15 ... 17: a third and a fourth face on the cube's edge 1 2
  soup.positions.emplace_back(0, 0, 4);
  add_polygon(soup, {1, 2, 15});
  add_polygon(soup, {2, 1, 16});
  const MeshReport report = inspect(TriangleMesh(soup));
  CHECK(report.unreferenced_vertices == 1);
  CHECK(report.named_duplicate_positions == std::vector<std::int32_t>{10});
  CHECK(report.named_degenerate_faces == std::vector<std::int32_t>{6});
  CHECK(report.named_duplicate_faces == std::vector<std::int32_t>{8});
  CHECK(report.named_non_manifold_edges == std::vector<std::array<std::int32_t, 2>>{{1, 2}});
  // Three sides of face 0 are flipped against their neighbour; the fourth has too many faces to say.
  CHECK(report.flipped_edges == 3);
  CHECK(report.components.size() == 3);
  CHECK_FALSE(report.components[0].manifold);
  CHECK_FALSE(report.components[0].genus.has_value());
  CHECK(report.orientable);
  CHECK(report.min_angle == 0);
}

TEST_CASE("mesh report: sheets that meet in a vertex", "[mesh_report]") {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  add_polygon(soup, {0, 1, 2});
  add_polygon(soup, {0, 3, 4});
  const MeshReport report = inspect(TriangleMesh(soup));
  CHECK(report.components.size() == 1);
  CHECK(report.named_non_manifold_vertices == std::vector<std::int32_t>{0});
}

TEST_CASE("mesh report: lists are short, counts complete", "[mesh_report]") {
  PolygonSoup soup;
  for (int i = 0; i < 30; ++i) {
    for (int k = 0; k < 3; ++k) soup.positions.emplace_back(k, 2 * k, 3 * k);
    add_polygon(soup, {3 * i, 3 * i + 1, 3 * i + 2});
  }
  const MeshReport report = inspect(TriangleMesh(soup));
  CHECK(report.degenerate_faces == 30);
  CHECK(report.named_degenerate_faces.size() == MeshReport::kNamed);
  CHECK(report.duplicate_positions == 87);
}

TEST_CASE("mesh report: real meshes are what the manifest says", "[mesh_report]") {
  for (const Row& row : kClean) check_row(row);
}

TEST_CASE("mesh report: dirty meshes are what the manifest says", "[mesh_report]") {
  for (const Row& row : kDirty) check_row(row);
  if (const auto report = report_of("dragon_48k_dirty.ply")) {
    CHECK(report->unreferenced_vertices == 16);
    CHECK(report->duplicate_faces == 1254);
  }
  if (const auto report = report_of("dragon_871k.ply")) {
    CHECK(report->duplicate_positions == 2100);
    CHECK(report->degenerate_faces == 108);
  }
  if (const auto report = report_of("teapot_dirty.obj")) {
    CHECK(report->border_edges == 1036);
    CHECK(report->duplicate_positions == 403);
  }
  if (const auto report = report_of("suzanne_quads.obj")) {
    CHECK(report->border_edges == 42);
    CHECK(report->duplicate_positions == 2);
    CHECK(report->duplicate_faces == 1);
  }
  if (const auto report = report_of("wuson_dirty.off")) {
    CHECK(report->border_edges == 2338);
    CHECK(report->duplicate_positions == 1088);
  }
  if (const auto report = report_of("polygon_mesh.off")) CHECK(report->border_edges == 489);
  if (const auto report = report_of("moebius.obj")) {
    CHECK(report->border_edges == 112);
    CHECK_FALSE(report->orientable);
  }
  if (const auto report = report_of("blobby_shuffled.off")) CHECK(report->orientable);
}

TEST_CASE("mesh report: STL soups come out welded", "[mesh_report]") {
  if (const auto report = report_of("motor_soup.stl")) {
    CHECK(report->components.size() == 12);
    CHECK(report->non_manifold_edges == 162);
    CHECK(report->duplicate_positions == 0);
  }
  if (const auto report = report_of("bunny_holes_soup.stl")) {
    // The same surface as bunny_holes_69k.obj.
    CHECK(report->vertices == 35947 - 1113);
    CHECK(report->faces == 69451);
    CHECK(report->boundary_loops == 5);
    CHECK(genus_of(*report) == 0);
  }
}

TEST_CASE("mesh report: welding joins the parts of a mesh with seams", "[mesh_report]") {
  const auto loose = report_of("wuson_dirty.off"), welded = report_of("wuson_dirty.off", {true, 0});
  if (!loose || !welded) return;
  CHECK(welded->duplicate_positions == 0);
  CHECK(welded->vertices == loose->vertices - loose->duplicate_positions);
  CHECK(welded->components.size() < loose->components.size());
  CHECK(welded->area == Approx(loose->area).epsilon(1e-12));
}

}  // namespace leastcost
