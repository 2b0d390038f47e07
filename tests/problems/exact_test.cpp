// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/exact/exact_search.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <sstream>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/exact/landmark_file.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "problems/exact/large_pages.hpp"
#include "problems/exact/metric_mesh.hpp"
#include "problems/exact/propagation.hpp"
#include "tests/problems/exact_reference.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

constexpr double kTableDigits = 1e-9;  // relative; the tables have twelve digits

/// Distances by source and vertex of the file, from a table "source,vertex,distance".
std::map<std::int32_t, std::vector<std::pair<std::int32_t, double>>> truth_table(const std::filesystem::path& file) {
  std::map<std::int32_t, std::vector<std::pair<std::int32_t, double>>> table;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::int32_t source = 0, vertex = 0;
    double distance = 0;
    char comma = ',';
    fields >> source >> comma >> vertex >> comma >> distance;
    table[source].emplace_back(vertex, distance);
  }
  return table;
}

enum class Terrain { flat, hills, mountains, needles, steps, wings };

/// A sheet of at most 5 x 4 cells with random heights, diagonals, orientations, and holes.
PolygonSoup random_sheet(Random& random, Terrain terrain) {
  const int nx = random.integer(2, 5), ny = random.integer(2, 4);
  const double amplitude = terrain == Terrain::flat        ? 0
                           : terrain == Terrain::hills     ? 0.5
                           : terrain == Terrain::mountains ? 2.0
                                                           : 1.0;
  const double squash = terrain == Terrain::needles ? std::pow(10.0, random.uniform(-6, -3)) : 1.0;
  const bool regular = terrain == Terrain::flat || terrain == Terrain::steps;
  const double jitter = regular ? 0 : 0.25;
  PolygonSoup soup;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double z = random.uniform(0, 1);
      soup.positions.emplace_back(i + jitter * random.uniform(-0.5, 0.5),
                                  (j + jitter * random.uniform(-0.5, 0.5)) * squash,
                                  terrain == Terrain::steps ? std::floor(2 * z) : amplitude * squash * z);
    }
  const auto triangle = [&](int a, int b, int c) {
    if (random.uniform(0, 1) < 0.3) std::swap(b, c);
    add_polygon(soup, {a, b, c});
  };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      if (terrain != Terrain::flat && random.uniform(0, 1) < 0.05) continue;
      const int a = j * (nx + 1) + i, b = a + 1, d = a + nx + 1, c = d + 1;
      if (terrain == Terrain::flat || random.uniform(0, 1) < 0.5) {
        triangle(a, b, c);
        triangle(a, c, d);
      } else {
        triangle(a, b, d);
        triangle(b, c, d);
      }
    }
  for (int k = 0; terrain == Terrain::wings && k < 3; ++k) {
    const int v = random.integer(0, nx - 1) + (nx + 1) * random.integer(0, ny);
    soup.positions.emplace_back(random.uniform(0, nx), random.uniform(0, ny), random.uniform(0, 2));
    triangle(v, v + 1, static_cast<int>(soup.positions.size()) - 1);
  }
  return soup;
}

/// In faces and on edges.
std::vector<SurfacePoint> random_points(Random& random, const TriangleMesh& mesh, int count) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    double a = random.uniform(0, 1), b = random.uniform(0, 1);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    if (i % 3 == 2) b = 1 - a;
    points.push_back({random.integer(0, mesh.face_count() - 1), Eigen::Vector3d(1 - a - b, a, b)});
    if (i % 3 == 2) points.back().barycentric[0] = 0;
  }
  return points;
}

SurfacePoint point_of(const TriangleMesh& mesh, const std::vector<SurfacePoint>& extra, std::size_t i) {
  const std::size_t vertices = static_cast<std::size_t>(mesh.vertex_count());
  return i < vertices ? vertex_point(mesh, static_cast<std::int32_t>(i)) : extra[i - vertices];
}

/// What random pairs of random sheets said, against the reference.
struct Tally {
  int pairs = 0, proved = 0, blocked = 0, false_bounds = 0, false_paths = 0;
};

Tally compare(Random& random, Terrain terrain, int meshes, double blow_up = 0) {
  Tally tally;
  for (int k = 0; k < meshes; ++k) {
    const TriangleMesh mesh(random_sheet(random, terrain));
    const std::vector<SurfacePoint> extra = random_points(random, mesh, 6);
    const ExactReference reference(mesh, extra);
    if (!reference.complete()) continue;
    ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    Landmarks marks = search.make_landmarks(4, workspace);
    if (blow_up > 0) {  // an index whose distances are wrong
      Landmarks wrong(fingerprint(mesh), static_cast<std::size_t>(mesh.vertex_count()));
      for (const std::int32_t l : marks.vertices()) {
        ExactDistances all = search.distances(vertex_point(mesh, l), workspace);
        for (double& d : all.at_least) d *= 1 + blow_up;
        for (double& d : all.at_most) d *= 1 + blow_up;
        wrong.add(l, all.at_least, all.at_most);
      }
      marks = wrong;
    }
    search.use(marks);
    for (std::size_t i = 0; i < reference.count(); ++i)
      for (std::size_t j = 0; j < reference.count(); ++j) {
        if (i == j || random.integer(0, 3) > 0) continue;
        const ExactResult found = search.shortest(point_of(mesh, extra, i), point_of(mesh, extra, j), workspace,
                                                  {.landmarks = blow_up > 0 || j % 2 == 0});
        const double truth = static_cast<double>(reference.distance(i, j));
        // Ends in faces are rounded to doubles for the library.
        const double rounding = 1e-15 * (truth + 10);
        ++tally.pairs;
        tally.proved += found.is_proved() ? 1 : 0;
        tally.blocked += found.outcome == ExactOutcome::blocked ? 1 : 0;
        if (std::isinf(truth)) {
          tally.false_paths += std::isfinite(found.length) ? 1 : 0;
          continue;
        }
        if (found.lower_bound > truth + rounding) ++tally.false_bounds;
        if (found.length < truth - rounding || (found.is_proved() && found.length > truth * (1 + 1e-9) + rounding))
          ++tally.false_paths;
      }
  }
  return tally;
}

}  // namespace

TEST_CASE("exact: a vector in large pages keeps what it holds while it grows") {
  LargeVector<std::int64_t> numbers;
  constexpr std::size_t kCount = 3 * LargePages<std::int64_t>::kPage / sizeof(std::int64_t);
  for (std::size_t i = 0; i < kCount; ++i) numbers.push_back(static_cast<std::int64_t>(i));
  LargeVector<std::int64_t> moved = std::move(numbers);
  const LargeVector<std::int64_t> copied = moved;
  moved.clear();
  moved.shrink_to_fit();
  CHECK(reinterpret_cast<std::uintptr_t>(copied.data()) % LargePages<std::int64_t>::kPage == 0);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < kCount; ++i) wrong += copied[i] == static_cast<std::int64_t>(i) ? 0 : 1;
  CHECK(wrong == 0);
}

TEST_CASE("exact: windows that were taken need half of the memory of those that wait") {
  // With all of its windows kept whole, the search needs more than it may take here.
  const TriangleMesh mesh(sphere(5));
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const SurfacePoint from = vertex_point(mesh, 0), to = vertex_point(mesh, 1);
  const ExactResult free = search.shortest(from, to, workspace);
  REQUIRE(free.is_proved());
  REQUIRE(free.windows > 1000);
  const double whole = 2 * sizeof(Window<double>) * static_cast<double>(free.windows);
  const ExactResult limited = search.shortest(from, to, workspace, {.max_memory = 0.8 * whole});
  CHECK(limited.is_proved());
  CHECK(limited.length == free.length);
  CHECK(limited.lower_bound == free.lower_bound);
  CHECK(search.shortest(from, to, workspace, {.max_memory = 0.1 * whole}).out_of_memory);
}

TEST_CASE("exact: all vertices of nine meshes as an independent program has them, and pairs from both sides") {
  const std::string name = GENERATE("bunny_3k.off", "double-torus_tri.off", "duck.obj", "elephant.off", "fandisk.off",
                                    "knot1.off", "lion.off", "rocker-arm.obj", "spot.obj");
  const auto model = data_file("meshes/" + name);
  const auto truth = data_file("truth/cgal_exact_" + name.substr(0, name.find('.')) + ".csv");
  if (!model || !truth) return;
  CAPTURE(name);
  const TriangleMesh mesh(read_mesh(*model));
  ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  search.use(search.make_landmarks(4, workspace));
  Random random;
  for (const auto& [source, rows] : truth_table(*truth)) {
    const SurfacePoint from = vertex_point(mesh, mesh.vertex_of_file(source));
    const ExactDistances all = search.distances(from, workspace);
    CHECK(all.complete);
    double worst = 0;
    for (const auto& [vertex, distance] : rows) {
      const std::size_t v = static_cast<std::size_t>(mesh.vertex_of_file(vertex));
      if (std::isinf(distance)) CHECK(std::isinf(all.at_most[v]));
      if (!(distance > 0) || std::isinf(distance)) continue;
      worst = std::max({worst, std::abs(all.at_most[v] / distance - 1), std::abs(all.at_least[v] / distance - 1)});
    }
    CHECK(worst < kTableDigits);
    for (int k = 0; k < test::trials(50); ++k) {
      const auto& [vertex, distance] =
          rows[static_cast<std::size_t>(random.integer(0, static_cast<int>(rows.size()) - 1))];
      if (!(distance > 0) || std::isinf(distance)) continue;
      const SurfacePoint to = vertex_point(mesh, mesh.vertex_of_file(vertex));
      const ExactResult there = search.shortest(from, to, workspace, {.landmarks = k % 2 == 0});
      const ExactResult back = search.shortest(to, from, workspace, {.landmarks = k % 2 == 1});
      CAPTURE(source, vertex);
      CHECK(there.is_proved());
      CHECK(back.is_proved());
      CHECK(std::abs(there.length / distance - 1) < kTableDigits);
      CHECK(std::abs(back.length / distance - 1) < kTableDigits);
      CHECK(lies_on(mesh, there.path));
      CHECK(check_straight(mesh, there.path) > -1e-9);
      CHECK(path_length(there.path) <= there.length);
    }
  }
}

/// Midpoint subdivision makes flat patches, whose vertices shortest paths run into.
TEST_CASE("exact: paths on a mesh that was subdivided are straight and on it") {
  Random random;
  int through = 0;
  for (int k = 0; k < 6; ++k) {
    MeshOptions finer;
    finer.subdivide = 1;
    const TriangleMesh mesh(random_sheet(random, Terrain::mountains), finer);
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    for (std::int32_t i = 0; i < mesh.vertex_count(); i += 3)
      for (std::int32_t j = i + 1; j < mesh.vertex_count(); j += 2) {
        const ExactResult found = search.shortest(vertex_point(mesh, i), vertex_point(mesh, j), workspace);
        if (found.path.points.empty()) continue;
        CAPTURE(k, i, j);
        CHECK(lies_on(mesh, found.path));
        CHECK(check_straight(mesh, found.path) > -1e-9);
        CHECK(path_length(found.path) == Approx(found.length).epsilon(1e-12));
        ++through;
      }
  }
  CHECK(through > 500);
}

TEST_CASE("exact: a flat sheet with a notch, every pair of vertices") {
  const auto model = data_file("truth/flat_triangular_mesh.off");
  const auto table = data_file("truth/flat_triangular_mesh_pairwise.csv");
  if (!model || !table) return;
  const TriangleMesh mesh(read_mesh(*model));
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  std::ifstream in(*table);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  REQUIRE(rows.size() == static_cast<std::size_t>(mesh.vertex_count()));
  double worst = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ExactDistances all = search.distances(vertex_point(mesh, static_cast<std::int32_t>(i)), workspace);
    for (std::size_t j = 0; j < rows.size(); ++j)
      if (rows[i][j] > 0) worst = std::max(worst, std::abs(all.at_most[j] - rows[i][j]));
  }
  CHECK(worst < 1e-9);
}

TEST_CASE("exact: no bound is above the truth, in 120 bits, and clean sheets are all proved") {
  const Terrain terrain = GENERATE(Terrain::flat, Terrain::hills, Terrain::mountains, Terrain::steps);
  CAPTURE(static_cast<int>(terrain));
  Random random;
  const Tally tally = compare(random, terrain, 18);
  CHECK(tally.pairs > 500);
  CHECK(tally.false_bounds == 0);
  CHECK(tally.false_paths == 0);
  CHECK(tally.proved == tally.pairs);
}

TEST_CASE("exact: sheets of needles are proved or say that they are not") {
  Random random;
  const Tally tally = compare(random, Terrain::needles, 18);
  CHECK(tally.pairs > 500);
  CHECK(tally.false_bounds == 0);
  CHECK(tally.false_paths == 0);
  CHECK(10 * tally.proved >= 9 * tally.pairs);
}

TEST_CASE("exact: a strip of needles takes twice the digits, and then it is proved") {
  Random random;
  PolygonSoup soup;
  constexpr int kCells = 60;
  constexpr double kHeight = 1e-6;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i <= kCells; ++i)
      soup.positions.emplace_back((i + random.uniform(-0.4, 0.4)) * kHeight, j, kHeight * random.uniform(-1, 1));
  for (int i = 0; i < kCells; ++i) {
    add_polygon(soup, {i, i + 1, i + kCells + 2});
    add_polygon(soup, {i, i + kCells + 2, i + kCells + 1});
  }
  const TriangleMesh mesh(soup);
  const ExactReference reference(mesh, {});
  REQUIRE(reference.complete());
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  int fine = 0;
  for (int k = 0; k < 300; ++k) {
    const std::int32_t i = random.integer(0, mesh.vertex_count() - 1), j = random.integer(0, mesh.vertex_count() - 1);
    if (i == j) continue;
    const ExactResult found = search.shortest(vertex_point(mesh, i), vertex_point(mesh, j), workspace);
    const Long truth = reference.distance(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    CAPTURE(i, j, found.twice_the_digits);
    CHECK(found.lower_bound <= truth);
    CHECK(found.is_proved());
    CHECK(found.length >= truth * (1 - Long(1e-9)));
    CHECK(found.length <= truth * (1 + Long(2e-9)));
    fine += found.twice_the_digits ? 1 : 0;
  }
  CHECK(fine > 0);
}

TEST_CASE("exact: paths go on over edges with three faces") {
  Random random;
  const Tally tally = compare(random, Terrain::wings, 18);
  CHECK(tally.pairs > 500);
  CHECK(tally.false_bounds == 0);
  CHECK(tally.false_paths == 0);
  CHECK(tally.proved == tally.pairs);
}

/// Two halves of a plane and a third sheet between them: straight across is 2.
TEST_CASE("exact: straight over an edge with three faces") {
  PolygonSoup soup;
  for (const auto& p :
       {std::array{-1, 0, 0}, std::array{1, 0, 0}, std::array{0, -5, 0}, std::array{0, 5, 0}, std::array{0, 0, 3}})
    soup.positions.emplace_back(p[0], p[1], p[2]);
  for (const auto& f : {std::array{0, 2, 3}, std::array{2, 1, 3}, std::array{2, 3, 4}})
    add_polygon(soup, {f[0], f[1], f[2]});
  const TriangleMesh mesh(soup);
  REQUIRE(mesh.non_manifold_edges().size() == 1);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const ExactResult found = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 1), workspace);
  CHECK(found.is_proved());
  CHECK(found.length == Approx(2).epsilon(1e-9));
  CHECK(check_straight(mesh, found.path) > -1e-9);
}

/// What is said after a stop is a bracket still, and several sources are the nearest of them.
TEST_CASE("exact: distances with several sources, a limit and budgets that are spent") {
  Random random;
  const TriangleMesh mesh(random_sheet(random, Terrain::mountains), {false, 2});
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const std::vector<SurfacePoint> sources = {vertex_point(mesh, 0), vertex_point(mesh, 3)};
  const ExactDistances first = search.distances(sources[0], workspace),
                       second = search.distances(sources[1], workspace);
  const ExactDistances both = search.distances(sources, workspace);
  CHECK_THROWS_AS(search.distances(std::span<const SurfacePoint>(), workspace), InputError);
  REQUIRE(both.complete);
  const double farthest = *std::max_element(both.at_most.begin(), both.at_most.end());
  const ExactDistances near = search.distances(sources, workspace, {.max_distance = farthest / 2});
  const ExactDistances spent = search.distances(sources, workspace, {.max_windows = both.windows / 3});
  const ExactDistances full = search.distances(sources, workspace, {.max_memory = 1e3});
  CHECK(spent.out_of_windows);
  CHECK(full.out_of_memory);
  int not_reached = 0;
  for (std::size_t v = 0; v < both.at_most.size(); ++v) {
    const double truth = std::min(first.at_most[v], second.at_most[v]), rounding = 1e-12 * farthest;
    CHECK(std::abs(both.at_most[v] - truth) <= rounding);
    for (const ExactDistances* some : {&near, &spent, &full}) {
      CHECK(some->at_least[v] <= truth + rounding);
      CHECK(some->at_most[v] >= truth - rounding);
      // The faces are divided into coplanar ones: windows that are joined there are as loose as the loosest of them.
      if (truth < some->seen_to * (1 - 1e-9)) CHECK(some->at_most[v] - some->at_least[v] <= 10 * rounding);
      not_reached += std::isinf(some->at_most[v]) ? 1 : 0;
    }
  }
  CHECK(not_reached > 0);
}

TEST_CASE("exact: the comparison finds an index that claims too much") {
  Random random;
  const Tally tally = compare(random, Terrain::mountains, 4, 0.05);
  CHECK(tally.false_bounds + tally.false_paths > 0);
}

TEST_CASE("exact: landmarks of another mesh are refused") {
  const TriangleMesh mesh(octahedron());
  PolygonSoup moved = octahedron();
  moved.positions.front().x() += 1e-12;
  const TriangleMesh other(moved);
  ExactSearch search(mesh), elsewhere(other);
  ExactSearch::Workspace workspace(elsewhere);
  const Landmarks marks = elsewhere.make_landmarks(2, workspace);
  CHECK(marks.count() == 2);
  CHECK_THROWS_WITH(search.use(marks), Catch::Contains("made for another mesh"));
}

TEST_CASE("exact: the cube, from corner to corner and from face to face") {
  const TriangleMesh mesh(cube());
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const ExactResult corner = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 7), workspace);
  CHECK(corner.outcome == ExactOutcome::proved);
  CHECK(corner.length == Approx(std::sqrt(5.0)).epsilon(1e-14));
  CHECK(corner.lower_bound <= std::sqrt(5.0));
  CHECK(corner.gap <= 1e-9);
  // Middles of opposite faces: four ways, all of length 2. Both lie on the diagonals of their faces.
  const auto middle = [&mesh](double z) {
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      const SurfacePoint p = point_on_face(mesh, f, Eigen::Vector3d(0, 0, z));
      if (mesh.point(p).isApprox(Eigen::Vector3d(0, 0, z))) return p;
    }
    return SurfacePoint{};
  };
  const ExactResult faces = search.shortest(middle(-0.5), middle(0.5), workspace);
  CHECK(faces.outcome == ExactOutcome::proved);
  CHECK(faces.length == Approx(2).epsilon(1e-14));
}

TEST_CASE("exact: ends that are one point, on one face, in two components") {
  PolygonSoup soup = cube();
  const std::int32_t first = static_cast<std::int32_t>(soup.positions.size());
  for (int k = 0; k < 3; ++k) soup.positions.emplace_back(5 + (k == 1), k == 2, 0);
  add_polygon(soup, {first, first + 1, first + 2});
  const TriangleMesh mesh(soup);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const ExactResult same = search.shortest(vertex_point(mesh, 3), vertex_point(mesh, 3), workspace);
  CHECK(same.is_proved());
  CHECK(same.length == 0);
  const SurfacePoint a{0, {0.2, 0.3, 0.5}}, b{0, {0.5, 0.25, 0.25}};
  const ExactResult inside = search.shortest(a, b, workspace);
  CHECK(inside.is_proved());
  CHECK(inside.length == Approx((mesh.point(a) - mesh.point(b)).norm()).epsilon(1e-14));
  const ExactResult apart = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, first), workspace);
  CHECK(apart.is_proved());
  CHECK(std::isinf(apart.length));
  CHECK(apart.path.points.empty());
}

TEST_CASE("exact: a longer path that is known is improved, the shortest is kept") {
  const TriangleMesh mesh(cube());
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const SurfacePoint from = vertex_point(mesh, 0), to = vertex_point(mesh, 7);
  const std::vector<std::int32_t> along_edges = {0, 1, 3, 7};
  const SurfacePath longer = path_from_vertices(mesh, from, along_edges, to);
  const ExactResult improved = search.shortest(from, to, workspace, {.start = &longer});
  CHECK(improved.outcome == ExactOutcome::improved);
  CHECK(improved.length == Approx(std::sqrt(5.0)).epsilon(1e-14));
  const ExactResult kept = search.shortest(from, to, workspace, {.start = &improved.path});
  CHECK(kept.outcome == ExactOutcome::proved);
  CHECK(kept.path.points == improved.path.points);
}

TEST_CASE("exact: a spent budget leaves a bound that holds") {
  Random random;
  const TriangleMesh mesh(random_sheet(random, Terrain::mountains));
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const SurfacePoint from = vertex_point(mesh, 0), to = vertex_point(mesh, mesh.vertex_count() - 1);
  const double length = search.shortest(from, to, workspace).length;
  double last = 0;
  for (const std::int64_t windows : {4, 16, 64}) {
    const ExactResult some = search.shortest(from, to, workspace, {.max_windows = windows});
    CHECK(some.lower_bound <= length);
    CHECK(some.lower_bound >= last);
    last = some.lower_bound;
    if (!some.is_proved()) CHECK(some.outcome == ExactOutcome::bounded);
  }
  CHECK(last > 0);
}

/// How often a search with faults on purpose claims more than the truth.
int false_claims(const Sabotage& sabotage) {
  Random random;
  int claims = 0;
  for (int k = 0; k < 6; ++k) {
    const TriangleMesh mesh(random_sheet(random, k % 2 == 0 ? Terrain::hills : Terrain::flat));
    const ExactReference reference(mesh, {});
    if (!reference.complete()) continue;
    const HalfEdges edges(mesh);
    Propagation<double> run(edges);
    for (std::int32_t i = 0; i < mesh.vertex_count(); ++i)
      for (std::int32_t j = 0; j < mesh.vertex_count(); ++j) {
        const EndPoint from = end_point(edges, vertex_point(mesh, i)), to = end_point(edges, vertex_point(mesh, j));
        QueryLimits limits;
        limits.sabotage = sabotage;
        run.run(from, &to, LowerBound(edges, &to, nullptr), limits);
        const Long truth = reference.distance(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        if (Long(run.lower_bound()) > truth + Long(1e-9)) ++claims;
      }
  }
  return claims;
}

TEST_CASE("exact: windows that are dropped, and cracks between them, are found by the comparison") {
  CHECK(false_claims({}) == 0);
  // A fold of the search that leaves out so few would pass any test of lengths.
  CHECK(false_claims({.drop_every = 10}) > 0);
  CHECK(false_claims({.crack = 1e-3}) > 0);
}

TEST_CASE("exact: paths to many vertices by one propagation are as long as those of single queries") {
  Random random;
  const TriangleMesh mesh(random_sheet(random, Terrain::mountains));
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  std::vector<std::int32_t> all(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  for (const SurfacePoint& from : {vertex_point(mesh, 0), SurfacePoint{0, {0.2, 0.3, 0.5}}}) {
    const std::vector<SurfacePath> paths = search.paths(from, all, workspace);
    for (const std::int32_t v : all) {
      const SurfacePath& path = paths[static_cast<std::size_t>(v)];
      const ExactResult alone = search.shortest(from, vertex_point(mesh, v), workspace);
      CHECK(path.points.empty() == std::isinf(alone.length));
      if (path.points.empty()) continue;
      CHECK(path_length(path) == Approx(alone.length).epsilon(1e-9).margin(1e-12));
      CHECK(lies_on(mesh, path));
      CHECK(path.points.front().isApprox(mesh.point(from)));
      CHECK(path.points.back() == mesh.position(v));
    }
  }
}

TEST_CASE("exact: an index on disk is what was written, and any other is refused") {
  const auto file = std::filesystem::temp_directory_path() / "leastcost_exact_test.landmarks";
  Random random;
  const TriangleMesh mesh(random_sheet(random, Terrain::hills));
  ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const Landmarks made = search.make_landmarks(5, workspace);
  write_landmarks(made, file);
  const Landmarks read = read_landmarks(file, search.made_for());
  CHECK(read.vertices() == made.vertices());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
    for (std::int32_t i = 0; i < made.count(); ++i) {
      CHECK(read.at_least(v, i) == made.at_least(v, i));
      CHECK(read.at_most(v, i) == made.at_most(v, i));
    }
  search.use(read);
  CHECK(search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 5), workspace).bound == "euclid + 5 landmarks");

  const MetricMesh turned(mesh, Eigen::Vector3d(1, 2, 1).asDiagonal());
  const ExactSearch in_metric(turned.mesh());
  CHECK_THROWS_WITH(read_landmarks(file, in_metric.made_for()), Catch::Contains("another metric"));
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto refusal = [&](const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
    try {
      read_landmarks(file, search.made_for());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const std::size_t left : {std::size_t{0}, std::size_t{7}, std::size_t{20}, bytes.size() / 2, bytes.size() - 1})
    CHECK_THAT(refusal(bytes.substr(0, left)), Catch::Contains("index"));
  for (std::size_t i = 0; i < bytes.size(); i += 7) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    CAPTURE(i);
    CHECK_THAT(refusal(changed), Catch::Contains("index"));
  }
  CHECK_THAT(refusal(bytes + "x"), Catch::Contains("index"));
  std::filesystem::remove(file);
  CHECK_THROWS_WITH(read_landmarks(file, search.made_for()), Catch::Contains("cannot be read"));
  CHECK_THROWS_WITH(read_landmarks(file.parent_path(), search.made_for()), Catch::Contains("a folder"));
}

/// On a convex flat sheet the least cost is |A d|; there and back the path is the same.
TEST_CASE("exact: a constant metric is the Euclidean one on a mesh that was turned") {
  PolygonSoup soup;
  constexpr int kSide = 6;
  for (int j = 0; j <= kSide; ++j)
    for (int i = 0; i <= kSide; ++i) soup.positions.emplace_back(1000 + i, j, 0.5 * j);
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const int a = j * (kSide + 1) + i;
      add_polygon(soup, {a, a + 1, a + kSide + 2});
      add_polygon(soup, {a, a + kSide + 2, a + kSide + 1});
    }
  const TriangleMesh mesh(soup);
  Eigen::Matrix3d root;
  root << 1, 0.3, 0, 0, 4, 0.2, 0, 0, 0.5;
  const MetricMesh turned(mesh, root);
  const ExactSearch search(turned.mesh());
  ExactSearch::Workspace workspace(search);
  for (std::int32_t v = 1; v < mesh.vertex_count(); v += 3) {
    const ExactResult found = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, v), workspace);
    CHECK(found.is_proved());
    CHECK(found.length == Approx((root * (mesh.position(v) - mesh.position(0))).norm()).epsilon(1e-12));
    const SurfacePath path = turned.back(found.path);
    CHECK(lies_on(mesh, path));
    CHECK(path_length(path, MetricRoot(root)) == Approx(found.length).epsilon(1e-12));
    CHECK(check_straight(mesh, path, MetricRoot(root)) > -1e-9);
  }
}

/// Rounding of the position of an end, relative to its coordinates, was as large as its distance from the vertex: the
/// paths on both sides of the vertex could not be told apart.
TEST_CASE("exact: an end beside a vertex of a mesh far from the origin takes few windows") {
  constexpr int kSide = 40;
  for (const double away : {0.0, 1e3, 1e6}) {
    PolygonSoup soup;
    for (int j = 0; j <= kSide; ++j)
      for (int i = 0; i <= kSide; ++i) {
        const double x = double(i) / kSide, y = double(j) / kSide;
        soup.positions.emplace_back(away + x, away + y, away + 0.1 * std::sin(13 * x) * std::cos(12 * y));
      }
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const int a = j * (kSide + 1) + i;
        add_polygon(soup, {a, a + 1, a + kSide + 2});
        add_polygon(soup, {a, a + kSide + 2, a + kSide + 1});
      }
    const TriangleMesh mesh(soup);
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    const int corner = 10 * kSide + 10;  // the square whose first corner is the vertex
    const SurfacePoint target{2 * (30 * kSide + 30), Eigen::Vector3d(0.5, 0.3, 0.2)};
    for (const double near : {1e-11, 1e-10, 1e-9, 1e-8, 1e-7}) {
      const SurfacePoint source{2 * corner, Eigen::Vector3d(1 - near, near, 0)};
      const ExactResult found = search.shortest(source, target, workspace);
      CAPTURE(away, near, found.windows);
      CHECK(found.is_proved());
      CHECK(found.windows < 100'000);
      if (away < 1e6) CHECK(lies_on(mesh, found.path));  // beyond, points are rounded by more than it allows
      CHECK(path_length(found.path) == Approx(found.length).epsilon(1e-7));
    }
  }
}

/// Far from the origin positions are known to 1e-10, and so are the lengths of paths: a proof allows for it.
TEST_CASE("exact: a mesh far from the origin is proved up to the rounding of positions") {
  constexpr double kAway = 1e6;
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    PolygonSoup soup = random_sheet(random, Terrain::hills);
    for (Eigen::Vector3d& x : soup.positions) x += Eigen::Vector3d(kAway, -2 * kAway, kAway);
    const TriangleMesh mesh(soup);
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    const SurfacePoint source{0, Eigen::Vector3d(0.21, 0.32, 0.47)},
        target{mesh.face_count() - 1, Eigen::Vector3d(0.2, 0.37, 0.43)};
    const ExactResult found = search.shortest(source, target, workspace);
    if (!std::isfinite(found.length)) continue;
    INFO("trial " << trial << ", gap " << found.gap);
    CHECK(found.is_proved());
    CHECK(found.gap <= 1e-7);
  }
}

}  // namespace leastcost::test
