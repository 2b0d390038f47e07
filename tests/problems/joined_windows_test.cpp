// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

constexpr double kRounding = 1e-11;  // relative

/// Rows of steps with coplanar faces, and holes where `holes`.
TriangleMesh steps(Random& random, int count, bool holes) {
  const PolygonSoup all = sheet(count, count, [&](double u, double v) {
    return Eigen::Vector3d(count * u, count * v, std::abs(std::fmod(8 * u, 2.0) - 1) * 0.1 * count);
  });
  PolygonSoup soup;
  soup.positions = all.positions;
  for (std::size_t c = 0; c < all.corners.size(); c += 3)
    if (!holes || random.uniform(0, 1) > 0.02)
      add_polygon(soup, {all.corners[c], all.corners[c + 1], all.corners[c + 2]});
  return TriangleMesh(soup);
}

TEST_CASE("windows: coplanar faces take few", "[exact]") {
  Random random(1);
  // Undivided, windows would come to a fifth of the number of faces squared, 50 per face.
  const int count = 48;
  for (const TriangleMesh& mesh :
       {TriangleMesh(sheet(count, count, [&](double u, double v) { return Eigen::Vector3d(count * u, count * v, 0); })),
        steps(random, count, false)}) {
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    const ExactDistances all =
        search.distances(vertex_point(mesh, random.integer(0, mesh.vertex_count() - 1)), workspace);
    CHECK(all.complete);
    CHECK(all.windows < 12 * mesh.face_count());
  }
}

TEST_CASE("windows: paths through joined ones are as long as the distances", "[exact]") {
  const int count = trials(6);
  for (int trial = 0; trial < count; ++trial) {
    CAPTURE(trial);
    Random random(400 + static_cast<unsigned>(trial));
    const TriangleMesh mesh = trial % 3 == 0   ? TriangleMesh(cube(), {.subdivide = 4})
                              : trial % 3 == 1 ? steps(random, 24, true)
                                               : TriangleMesh(sphere(1), {.subdivide = 3});
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    const std::int32_t source = random.integer(0, mesh.vertex_count() - 1);
    const ExactDistances all = search.distances(vertex_point(mesh, source), workspace);
    std::vector<std::int32_t> to;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
      if (v != source && std::isfinite(all.distance[static_cast<std::size_t>(v)])) to.push_back(v);
    const std::vector<SurfacePath> paths = search.paths(vertex_point(mesh, source), to, workspace);
    for (std::size_t i = 0; i < to.size(); ++i) {
      const double distance = all.distance[static_cast<std::size_t>(to[i])];
      CAPTURE(to[i], distance);
      REQUIRE(paths[i].points.size() > 1);
      CHECK(path_length(paths[i]) == Approx(distance).epsilon(kRounding).margin(0));
    }
    // The same by queries of pairs, which take windows in another order.
    for (int k = 0; k < 20; ++k) {
      const std::size_t i = static_cast<std::size_t>(random.integer(0, static_cast<int>(to.size()) - 1));
      const ExactResult found =
          search.shortest(vertex_point(mesh, source), vertex_point(mesh, to[i]), workspace, {.fronts = k % 2 == 0});
      CHECK(found.is_proved());
      CHECK(found.length == Approx(all.distance[static_cast<std::size_t>(to[i])]).epsilon(kRounding).margin(0));
    }
  }
}

}  // namespace
}  // namespace leastcost::test
