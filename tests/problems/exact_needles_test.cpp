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

/// Counts what the search came to, where the distance is `truth` but for `rounding`.
void judge(const ExactResult& found, double truth, double rounding, Counts& counts) {
  ++counts.pairs;
  counts.unproved += found.is_proved() ? 0 : 1;
  if (found.lower_bound > truth + rounding || found.length < truth - rounding ||
      found.length > truth * (1 + 1e-9) + rounding)
    ++counts.wrong;
}

/// Over so many faces paths may differ by a gap each.
constexpr double kFacesMoved = 100;

/// `gap`: how far the added vertices are moved away from the divided ones, length units.
Counts compare_split(Random& random, double amplitude, int meshes, double gap = 0) {
  Counts counts;
  for (int k = 0; k < meshes; ++k) {
    Sheet sheet = random_sheet_of(random, amplitude);
    const TriangleMesh whole(sheet.soup());
    const ExactReference reference(whole, {});
    if (!reference.complete()) continue;
    const int splits = random.integer(1, 6);
    for (int i = 0; i < splits; ++i)
      split(random, sheet, random.integer(0, static_cast<int>(sheet.positions.size()) - 1));
    for (std::size_t i = reference.count(); i < sheet.positions.size(); ++i)
      for (Eigen::Index axis = 0; axis < 3; ++axis) sheet.positions[i][axis] += gap * random.uniform(-0.5, 0.5);
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
        const double truth = static_cast<double>(reference.distance(i, j));
        const double rounding = 1e-15 * (truth + 10) + gap * kFacesMoved;
        const std::size_t v = static_cast<std::size_t>(here(j));
        if (all.at_least[v] > truth + rounding || all.at_most[v] < truth - rounding ||
            !(all.at_most[v] - all.at_least[v] < 1e-10 * truth))
          ++counts.wrong_distances;
        if (random.integer(0, 3) > 0) continue;
        const ExactResult found = search.shortest(vertex_point(mesh, here(i)), vertex_point(mesh, here(j)), workspace,
                                                  {.max_windows = 100'000});
        judge(found, truth, rounding, counts);
        // Again with the path known, and bounds by fronts around the end.
        judge(search.shortest(vertex_point(mesh, here(i)), vertex_point(mesh, here(j)), workspace,
                              {.start = &found.path}),
              truth, rounding, counts);
      }
    }
  }
  return counts;
}

/// A place in a face without inside, and the same place in a face of the mesh without such faces, which comes first.
struct Places {
  SurfacePoint plain, needle;
};

/// Of sheet `split`, whose vertices are at the places of those of `whole`.
std::vector<Places> places_in_needles(Random& random, const Sheet& whole, const Sheet& split) {
  std::vector<Places> places;
  for (std::size_t f = whole.faces.size(); f < split.faces.size(); ++f) {
    const Eigen::Vector3d weights(random.integer(0, 2) == 0 ? 0 : random.uniform(0, 1), random.uniform(0, 1),
                                  random.integer(0, 2) == 0 ? 0 : random.uniform(0, 1));
    for (std::size_t g = 0; g < whole.faces.size(); ++g) {
      Eigen::Vector3d same = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          if (whole.positions[static_cast<std::size_t>(whole.faces[g][static_cast<std::size_t>(i)])] ==
              split.positions[static_cast<std::size_t>(split.faces[f][static_cast<std::size_t>(k)])])
            same[i] += weights[k];
      if (!(same.sum() > weights.sum() * (1 - 1e-9))) continue;
      places.push_back(
          {{static_cast<std::int32_t>(g), same / same.sum()}, {static_cast<std::int32_t>(f), weights / weights.sum()}});
      break;
    }
  }
  return places;
}

/// Paths from and to places in faces without inside, and places on the edges beside them.
Counts compare_ends(Random& random, double amplitude, int meshes) {
  Counts counts;
  for (int k = 0; k < meshes; ++k) {
    const Sheet plain = random_sheet_of(random, amplitude);
    Sheet sheet = plain;
    const TriangleMesh whole(plain.soup());
    const int around = random.integer(0, static_cast<int>(plain.positions.size()) - 1);
    for (int i = 0; i < 8; ++i)
      split(random, sheet, i % 2 == 0 ? around : random.integer(0, static_cast<int>(sheet.positions.size()) - 1));
    const std::vector<Places> places = places_in_needles(random, plain, sheet);
    std::vector<SurfacePoint> extra;
    for (const Places& p : places) extra.push_back(p.plain);
    const ExactReference reference(whole, extra);
    if (!reference.complete()) continue;
    const std::size_t vertices = reference.count() - extra.size();
    const TriangleMesh mesh(sheet.soup());
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const ExactDistances all = search.distances(places[i].needle, workspace, {.max_windows = 100'000});
      counts.wrong_distances += all.complete ? 0 : 1;
      for (std::size_t j = 0; j < reference.count(); ++j) {
        const double truth = static_cast<double>(reference.distance(vertices + i, j)), rounding = 1e-14 * (truth + 10);
        if (j < vertices && (all.at_least[j] > truth + rounding || all.at_most[j] < truth - rounding ||
                             !(all.at_most[j] - all.at_least[j] < 1e-10 * truth + rounding)))
          ++counts.wrong_distances;
        if (!(truth > 1e-3) || random.integer(0, 3) > 0) continue;
        // Between a needle and a vertex, a needle, a place on an edge that may be beside one.
        const bool is_vertex = j < vertices;
        const SurfacePoint to = is_vertex                   ? vertex_point(mesh, static_cast<std::int32_t>(j))
                                : random.integer(0, 1) == 0 ? places[j - vertices].needle
                                                            : places[j - vertices].plain;
        const bool turned = random.integer(0, 1) == 0;
        const ExactResult found = search.shortest(turned ? to : places[i].needle, turned ? places[i].needle : to,
                                                  workspace, {.max_windows = 100'000});
        judge(found, truth, rounding, counts);
      }
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("exact: paths begin and end in faces with two corners at one place") {
  const double amplitude = GENERATE(0.0, 0.5, 2.0);
  CAPTURE(amplitude);
  Random random(43);
  const Counts counts = compare_ends(random, amplitude, test::trials(40));
  CHECK(counts.pairs > (kSanitized ? 30 : 500));
  CHECK(counts.unproved == 0);
  CHECK(counts.wrong == 0);
  CHECK(counts.wrong_distances == 0);
}

TEST_CASE("exact: in a ring of faces with two corners at one place a search ends") {
  // Corners 3, 4, 5 are at the place of corner 1, and joined to corner 0 alone.
  PolygonSoup soup;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)})
    soup.positions.push_back(p);
  for (int i = 0; i < 3; ++i) soup.positions.push_back(soup.positions[1]);
  add_polygon(soup, {0, 1, 2});
  for (int i = 0; i < 3; ++i) add_polygon(soup, {0, 3 + i, 3 + (i + 1) % 3});
  const TriangleMesh mesh(soup);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const SurfacePoint inside{1, Eigen::Vector3d(0.5, 0.2, 0.3)}, beside{1, Eigen::Vector3d(0, 0.2, 0.8)};
  const ExactDistances all = search.distances(inside, workspace, {.max_windows = 1000});
  CHECK(all.complete);
  CHECK(all.distance[2] == Approx(1.5));
  CHECK(search.distances(beside, workspace, {.max_windows = 1000}).distance[2] == Approx(2));
}

TEST_CASE("exact: far from the origin along one axis what is small along another one stays as it is") {
  PolygonSoup soup;
  const double small = 1e-13;
  for (const auto& [y, z] : {std::array{0.7, 0.3}, {0.0, 0.0}, {small, 0.0}, {0.0, small}, {1.0, 0.0}, {0.0, 1.0}})
    soup.positions.emplace_back(1e6, y, z);
  add_polygon(soup, {1, 2, 3});
  add_polygon(soup, {2, 4, 0});
  add_polygon(soup, {3, 2, 0});
  add_polygon(soup, {3, 0, 5});
  const TriangleMesh mesh(soup);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const ExactDistances all = search.distances(vertex_point(mesh, 1), workspace);
  CHECK(all.at_least[2] <= small);
  CHECK(all.at_most[2] >= small);
  CHECK(search.shortest(vertex_point(mesh, 1), vertex_point(mesh, 2), workspace).lower_bound <= small);
}

TEST_CASE("exact: faces with two corners at one place change no distance and block nothing") {
  const double amplitude = GENERATE(0.0, 0.5, 2.0);
  CAPTURE(amplitude);
  Random random(41);
  const Counts counts = compare_split(random, amplitude, test::trials(30));
  CHECK(counts.pairs > (kSanitized ? 100 : 3000));
  CHECK(counts.unproved == 0);
  CHECK(counts.wrong == 0);
  CHECK(counts.wrong_distances == 0);
}

TEST_CASE("exact: distances are complete beside two vertices that are nearly at one place") {
  PolygonSoup soup;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) soup.positions.emplace_back(i, j, i == 1 && j == 1 ? 0 : (i + j) % 2 * 0.1);
  soup.positions.emplace_back(soup.positions[4] + Eigen::Vector3d(1e-15, 0, 0));
  const std::array<int, 8> ring = {0, 1, 2, 5, 8, 7, 6, 3};
  for (std::size_t k = 0; k < ring.size(); ++k)
    add_polygon(soup, {k < 4 ? 4 : 9, ring[k], ring[(k + 1) % ring.size()]});
  add_polygon(soup, {9, 0, 4});
  add_polygon(soup, {4, 8, 9});
  const TriangleMesh mesh(soup);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const auto here = [&](int v) { return mesh.vertex_of_file(v); };
  const ExactDistances all = search.distances(vertex_point(mesh, here(1)), workspace, {.max_windows = 100'000'000});
  CHECK(all.complete);
  const double straight = (mesh.position(here(2)) - mesh.position(here(1))).norm();
  const std::size_t beside = static_cast<std::size_t>(here(2));
  CHECK(all.at_least[beside] <= straight * (1 + 1e-15));
  CHECK(all.at_most[beside] >= straight * (1 - 1e-15));
  CHECK(all.at_most[beside] - all.at_least[beside] < 1e-12);
  const ExactResult apart = search.shortest(vertex_point(mesh, here(4)), vertex_point(mesh, here(9)), workspace);
  CHECK(apart.is_proved());  // the gap itself
  CHECK(apart.length == Approx((mesh.position(here(9)) - mesh.position(here(4))).norm()));
}

TEST_CASE("exact: vertices within rounding of each other count as at one place", "[slow_sanitized]") {
  const double amplitude = GENERATE(0.0, 1.0), gap = GENERATE(1e-15, 1e-14, 1e-13);
  CAPTURE(amplitude, gap);
  Random random(43);
  const Counts counts = compare_split(random, amplitude, test::trials(10), gap);
  CHECK(counts.pairs > 300);
  CHECK(counts.unproved == 0);
  CHECK(counts.wrong == 0);
  CHECK(counts.wrong_distances == 0);
}

}  // namespace leastcost::test
