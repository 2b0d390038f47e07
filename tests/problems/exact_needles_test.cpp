// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include "tests/problems/exact_reference.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

/// Scans have faces with two corners at one place. They have no inside, so that the surface is that of the mesh without
/// them, whose distances are found by brute force.
namespace leastcost::test {
namespace {

using Face = std::array<int, 3>;

struct Sheet {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Face> faces;  // of one orientation

  PolygonSoup soup() const {
    PolygonSoup soup;
    soup.positions = positions;
    for (const Face& f : faces) add_polygon(soup, {f[0], f[1], f[2]});
    return soup;
  }
};

Sheet random_sheet_of(Random& random, double amplitude) {
  const int nx = random.integer(3, 5), ny = random.integer(3, 4);
  Sheet sheet;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double x = i + random.uniform(-0.1, 0.1), y = j + random.uniform(-0.1, 0.1);
      sheet.positions.emplace_back(x, y, amplitude * random.uniform(0, 1));
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, d = a + nx + 1, c = d + 1;
      const bool falling = random.integer(0, 1) == 1;
      sheet.faces.push_back({a, b, falling ? d : c});
      sheet.faces.push_back({falling ? b : a, c, d});
    }
  return sheet;
}

/// Divides vertex v in two at the same place: the faces around it from one neighbour to another keep v, the others get
/// the new one, and two faces without inside join them. Nothing at a border.
void split(Random& random, Sheet& sheet, int v) {
  std::map<int, int> next;  // neighbour after neighbour, counterclockwise
  for (const Face& f : sheet.faces)
    for (std::size_t k = 0; k < 3; ++k)
      if (f[k] == v) next[f[(k + 1) % 3]] = f[(k + 2) % 3];
  std::vector<int> ring = {next.begin()->first};
  while (next.count(ring.back()) > 0 && next[ring.back()] != ring.front()) ring.push_back(next[ring.back()]);
  if (ring.size() != next.size() || next.count(ring.back()) == 0) return;
  std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<int>(ring.size()) - 1), ring.end());
  const std::size_t kept = static_cast<std::size_t>(random.integer(1, static_cast<int>(ring.size()) - 1));
  const int p = ring.front(), q = ring[kept], added = static_cast<int>(sheet.positions.size());
  sheet.positions.push_back(sheet.positions[static_cast<std::size_t>(v)]);
  const std::vector<int> others(ring.begin() + static_cast<std::ptrdiff_t>(kept), ring.end());
  for (Face& f : sheet.faces)
    for (std::size_t k = 0; k < 3; ++k)
      if (f[k] == v && std::find(others.begin(), others.end(), f[(k + 1) % 3]) != others.end()) f[k] = added;
  sheet.faces.push_back({added, p, v});
  sheet.faces.push_back({v, q, added});
}

struct Counts {
  int pairs = 0, unproved = 0, wrong = 0, wrong_distances = 0;
};

Counts compare_split(Random& random, double amplitude, int meshes) {
  Counts counts;
  for (int k = 0; k < meshes; ++k) {
    Sheet sheet = random_sheet_of(random, amplitude);
    const TriangleMesh whole(sheet.soup());
    const ExactReference reference(whole, {});
    if (!reference.complete()) continue;
    const int splits = random.integer(1, 6);
    for (int i = 0; i < splits; ++i)
      split(random, sheet, random.integer(0, static_cast<int>(sheet.positions.size()) - 1));
    const TriangleMesh mesh(sheet.soup());
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    const auto here = [&](std::size_t i) {
      return mesh.vertex_of_file(whole.file_vertex(static_cast<std::int32_t>(i)));
    };
    for (std::size_t i = 0; i < reference.count(); ++i) {
      const ExactDistances all = search.distances(vertex_point(mesh, here(i)), workspace, {.max_windows = 100'000});
      counts.wrong_distances += all.complete ? 0 : 1;
      for (std::size_t j = 0; j < reference.count(); ++j) {
        if (i == j) continue;
        const double truth = static_cast<double>(reference.distance(i, j)), rounding = 1e-15 * (truth + 10);
        const std::size_t v = static_cast<std::size_t>(here(j));
        if (all.at_least[v] > truth + rounding || all.at_most[v] < truth - rounding ||
            !(all.at_most[v] - all.at_least[v] < 1e-10 * truth))
          ++counts.wrong_distances;
        if (random.integer(0, 3) > 0) continue;
        const ExactResult found = search.shortest(vertex_point(mesh, here(i)), vertex_point(mesh, here(j)), workspace,
                                                  {.max_windows = 100'000});
        // Again with the path known, and bounds by fronts around the end.
        const ExactResult again = search.shortest(vertex_point(mesh, here(i)), vertex_point(mesh, here(j)), workspace,
                                                  {.start = &found.path});
        counts.unproved += again.is_proved() ? 0 : 1;
        if (again.lower_bound > truth + rounding || again.length < truth - rounding) ++counts.wrong;
        ++counts.pairs;
        counts.unproved += found.is_proved() ? 0 : 1;
        if (found.lower_bound > truth + rounding || found.length < truth - rounding ||
            found.length > truth * (1 + 1e-9) + rounding)
          ++counts.wrong;
      }
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("exact: faces with two corners at one place change no distance and block nothing") {
  const double amplitude = GENERATE(0.0, 0.5, 2.0);
  CAPTURE(amplitude);
  Random random(41);
  const Counts counts = compare_split(random, amplitude, test::trials(30));
  CHECK(counts.pairs > (kSanitized ? 50 : 1500));
  CHECK(counts.unproved == 0);
  CHECK(counts.wrong == 0);
  CHECK(counts.wrong_distances == 0);
}

}  // namespace leastcost::test
