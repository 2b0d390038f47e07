// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include "tests/problems/exact_reference.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

/// Regular meshes: their vertices lie on common rays from every vertex, so that windows end at vertices all the time.
/// Each mesh is a coarse one, whose distances are found by brute force, subdivided: the same surface as a lattice.
namespace leastcost::test {
namespace {

enum class Shape { flat, steps, box };

/// A box, or a sheet of squares with notches and holes, its corners at whole heights; turned, scaled and moved.
PolygonSoup coarse_shape(Random& random, Shape shape) {
  PolygonSoup soup;
  if (shape == Shape::box) {
    soup = cube();
    const Eigen::Vector3d size(random.integer(1, 3), random.integer(1, 3), random.integer(1, 3));
    for (Eigen::Vector3d& p : soup.positions) p = p.cwiseProduct(size).eval();
  } else {
    const int nx = random.integer(2, 4), ny = random.integer(2, 4);
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) soup.positions.emplace_back(i, j, shape == Shape::steps ? random.integer(0, 1) : 0);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        if (i + j > 0 && random.uniform(0, 1) < 0.15) continue;
        const int a = j * (nx + 1) + i, b = a + 1, d = a + nx + 1, c = d + 1;
        const bool falling = random.integer(0, 1) == 1;
        add_polygon(soup, {a, b, falling ? d : c});
        add_polygon(soup, {falling ? b : a, c, d});
      }
  }
  if (random.integer(0, 1) == 0) return soup;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1))
          .normalized();
  const double scale = std::pow(10.0, random.uniform(-3, 3));
  const Eigen::Vector3d shift = scale * random.uniform(0, 100) * Eigen::Vector3d(1, -2, 0.5);
  for (Eigen::Vector3d& p : soup.positions) p = (scale * (turn * p) + shift).eval();
  return soup;
}

/// A place of the coarse mesh: in a face, on an edge, at a vertex of the lattice.
SurfacePoint random_place(Random& random, const TriangleMesh& coarse, int cells) {
  int a = random.integer(0, cells), b = random.integer(0, cells);
  if (a + b > cells) a = cells - a, b = cells - b;
  Eigen::Vector3d at = Eigen::Vector3d(cells - a - b, a, b) / cells;
  if (random.integer(0, 1) == 0) {
    const double s = random.uniform(0, 1);
    at = ((1 - s) * at + s * Eigen::Vector3d(0.2, 0.5, 0.3)).eval();
  }
  return {random.integer(0, coarse.face_count() - 1), at};
}

struct Counts {
  int pairs = 0, unproved = 0, wrong = 0;
};

/// Pairs of places on lattices of 2^`levels` cells to an edge of the coarse meshes, with so many windows per face at
/// most.
Counts compare_lattices(Random& random, Shape shape, int meshes, int levels, std::int64_t windows) {
  Counts counts;
  for (int k = 0; k < meshes; ++k) {
    const PolygonSoup soup = coarse_shape(random, shape);
    const TriangleMesh coarse(soup), fine(soup, {.subdivide = levels});
    std::vector<SurfacePoint> places;
    for (int i = 0; i < 8; ++i) places.push_back(random_place(random, coarse, 1 << levels));
    const ExactReference reference(coarse, places);
    if (!reference.complete()) continue;
    const ExactSearch search(fine);
    ExactSearch::Workspace workspace(search);
    const std::size_t first = static_cast<std::size_t>(coarse.vertex_count());
    for (std::size_t i = 0; i < reference.count(); ++i)
      for (std::size_t j = i + 1; j < reference.count(); j += 2) {
        const auto end = [&](std::size_t p) {
          return p < first ? vertex_point(fine, fine.vertex_of_file(coarse.file_vertex(static_cast<std::int32_t>(p))))
                           : fine.locate(coarse.in_file(places[p - first]));
        };
        const double truth = static_cast<double>(reference.distance(i, j));
        if (!(truth > 0) || std::isinf(truth)) continue;
        const ExactResult found =
            search.shortest(end(i), end(j), workspace, {.max_windows = windows * fine.face_count()});
        ++counts.pairs;
        counts.unproved += found.is_proved() ? 0 : 1;
        const double rounding = 1e-12 * (truth + coarse.diameter());
        if (found.lower_bound > truth + rounding || found.length < truth - rounding ||
            (found.is_proved() && found.length > truth * (1 + 1e-9) + rounding))
          ++counts.wrong;
        // Again with the path known, and bounds by fronts around the end.
        const ExactResult again = search.shortest(end(i), end(j), workspace, {.start = &found.path});
        counts.unproved += again.is_proved() ? 0 : 1;
        if (again.lower_bound > truth + rounding || again.length < truth - rounding) ++counts.wrong;
      }
  }
  return counts;
}

}  // namespace

TEST_CASE("exact: lattices, turned and scaled, are proved, and as long as by brute force on their coarse faces") {
  const Shape shape = GENERATE(Shape::flat, Shape::steps, Shape::box);
  CAPTURE(static_cast<int>(shape));
  Random random(31);
  const Counts counts = compare_lattices(random, shape, test::trials(8), 4, 40);
  CHECK(counts.pairs > (kSanitized ? 10 : 200));
  CHECK(counts.unproved == 0);
  CHECK(counts.wrong == 0);
}

TEST_CASE("exact: many lattices, fine ones", "[.slow]") {
  const Shape shape = GENERATE(Shape::flat, Shape::steps, Shape::box);
  CAPTURE(static_cast<int>(shape));
  Random random(977);
  const Counts counts = compare_lattices(random, shape, 15, 5, 100);  // one pair takes 64
  CHECK(counts.unproved == 0);
  CHECK(counts.wrong == 0);
}

/// The shortest path runs along edges of the lattice: from vertex to vertex it grazes them.
TEST_CASE("exact: bounds stay tight where a path grazes edges of a lattice") {
  PolygonSoup soup;
  soup.positions = {{1, 0, 1}, {2, 0, 0}, {0, 1, 1}, {1, 1, 1}, {0, 2, 1},
                    {1, 2, 0}, {2, 2, 1}, {0, 3, 1}, {1, 3, 1}, {2, 3, 1}};
  add_polygon(soup, {0, 3, 2});
  add_polygon(soup, {0, 1, 3});
  add_polygon(soup, {2, 3, 5});
  add_polygon(soup, {2, 5, 4});
  add_polygon(soup, {3, 6, 5});
  add_polygon(soup, {4, 5, 7});
  add_polygon(soup, {5, 8, 7});
  add_polygon(soup, {5, 6, 9});
  add_polygon(soup, {5, 9, 8});
  const int levels = GENERATE(2, 3, 4);
  CAPTURE(levels);
  const TriangleMesh coarse(soup), fine(soup, {.subdivide = levels});
  const ExactReference reference(coarse, {});
  REQUIRE(reference.complete());
  const ExactSearch search(fine);
  ExactSearch::Workspace workspace(search);
  for (std::int32_t i = 0; i < coarse.vertex_count(); ++i) {
    const auto end = [&](std::int32_t v) { return vertex_point(fine, fine.vertex_of_file(coarse.file_vertex(v))); };
    const ExactDistances all = search.distances(end(i), workspace);
    for (std::int32_t j = 0; j < coarse.vertex_count(); ++j) {
      if (i == j) continue;
      const double truth =
          static_cast<double>(reference.distance(static_cast<std::size_t>(i), static_cast<std::size_t>(j)));
      const std::size_t there = static_cast<std::size_t>(fine.vertex_of_file(coarse.file_vertex(j)));
      CAPTURE(i, j);
      CHECK(all.at_least[there] <= truth * (1 + 1e-15));
      CHECK(all.at_most[there] >= truth * (1 - 1e-15));
      CHECK(all.at_most[there] - all.at_least[there] < 1e-10 * truth);
      const ExactResult found = search.shortest(end(i), end(j), workspace);
      CHECK(found.is_proved());
      CHECK_FALSE(found.twice_the_digits);
      CHECK(found.length <= truth * (1 + 1e-9));
    }
  }
}

TEST_CASE("exact: distances over a flat grid are those of the plane, for a jittered grid's number of windows") {
  const auto grid = [](int n, bool jitter, double turn, double shift) {
    Random random(5);
    PolygonSoup soup;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const bool inside = i > 0 && j > 0 && i < n && j < n;
        const double x = i + (jitter && inside ? random.uniform(-0.2, 0.2) : 0);
        const double y = j + (jitter && inside ? random.uniform(-0.2, 0.2) : 0);
        soup.positions.emplace_back(std::cos(turn) * x - std::sin(turn) * y + shift,
                                    std::sin(turn) * x + std::cos(turn) * y - shift, 0.25 * x);
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
        add_polygon(soup, {a, b, c});
        add_polygon(soup, {a, c, d});
      }
    return TriangleMesh(soup);
  };
  const int n = kSanitized ? 20 : 60;
  const auto distances = [&](const TriangleMesh& mesh, std::int32_t source) {
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    return search.distances(vertex_point(mesh, source), workspace, {.max_windows = 5'000'000});
  };
  const std::int64_t jittered = distances(grid(n, true, 0, 0), 0).windows;
  for (const auto& [turn, shift] : {std::pair(0.0, 0.0), std::pair(0.7, 0.0), std::pair(0.7, 4e6)}) {
    const TriangleMesh mesh = grid(n, false, turn, shift);
    CAPTURE(turn, shift);
    for (const std::int32_t source : {0, n / 2, (n + 1) * (n / 2) + n / 3}) {
      const ExactDistances all = distances(mesh, source);
      REQUIRE(all.complete);
      CHECK(all.windows < 2 * jittered);
      double worst = 0;
      for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
        const double truth = (mesh.position(v) - mesh.position(source)).norm();
        if (v != source) worst = std::max(worst, std::abs(all.distance[static_cast<std::size_t>(v)] / truth - 1));
        CHECK(all.at_least[static_cast<std::size_t>(v)] <= truth * (1 + 1e-15 * n));
      }
      CHECK(worst < 1e-12);
    }
  }
}

/// Every other vertex is a root, whose windows are as narrow as what the noise adds to a full turn, about 1e-12, along
/// rays through all vertices of the lattice.
TEST_CASE("exact: a lattice with little noise takes few more windows than one with more") {
  const int n = kSanitized ? 20 : 60;
  const auto noisy = [&](double noise) {
    Random random(7);
    return TriangleMesh(sheet(n - 1, n - 1, [&](double x, double y) {
      return Eigen::Vector3d(std::round((n - 1) * x), std::round((n - 1) * y), noise * random.normal());
    }));
  };
  const auto distances = [](const TriangleMesh& mesh) {
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    return search.distances(vertex_point(mesh, 0), workspace, {.max_windows = 5'000'000});
  };
  const std::int64_t usual = distances(noisy(1e-5)).windows;
  for (const double noise : {1e-7, 3e-7, 1e-6, 3e-6}) {
    CAPTURE(noise);
    const TriangleMesh mesh = noisy(noise);
    const ExactDistances all = distances(mesh);
    REQUIRE(all.complete);
    CHECK(all.windows < 3 * usual);
    for (std::int32_t v = 1; v < mesh.vertex_count(); ++v) {
      const double straight = (mesh.position(v) - mesh.position(0)).norm();
      const std::size_t i = static_cast<std::size_t>(v);
      // Over noise of z no path is longer than its own plan by more than the slopes' squares.
      if (!(all.at_most[i] >= straight * (1 - 1e-15) && all.at_least[i] <= straight * (1 + 10 * noise * noise) &&
            all.at_most[i] - all.at_least[i] < 1e-10 * straight))
        FAIL_CHECK("vertex " << v);
    }
  }
}

}  // namespace leastcost::test
