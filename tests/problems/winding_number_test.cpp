// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/winding_number.hpp"

#include "problems/distance/orient_faces.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;
constexpr double kDipoles = 0.02;  ///< what the groups of far triangles may be off

/// The same with the orientation of some faces reversed.
template <class Reverse>
TriangleMesh reversed(const TriangleMesh& mesh, Reverse reverse) {
  PolygonSoup soup = soup_of(mesh);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f)
    if (reverse(f))
      std::swap(soup.corners[static_cast<std::size_t>(3 * f)], soup.corners[static_cast<std::size_t>(3 * f) + 1]);
  return TriangleMesh(soup);
}

}  // namespace

TEST_CASE("winding number: 1 inside, 0 outside, -1 inside what is inside out") {
  Random random;
  const TriangleMesh ball{sphere(4)};
  const WindingNumber winding(ball), other(reversed(ball, [](int) { return true; }));
  for (int n = 0; n < 200; ++n) {
    const double r = n % 2 == 0 ? random.uniform(0, 0.99) : random.uniform(1.001, 5);
    const Vector3d x = r * random.vector(3).normalized();
    CHECK(winding.at(x) == Approx(r < 1 ? 1 : 0).margin(kDipoles));
    CHECK(other.at(x) == Approx(r < 1 ? -1 : 0).margin(kDipoles));
  }
}

TEST_CASE("winding number: exact beside faces, edges and vertices of a cube") {
  const WindingNumber winding{TriangleMesh(cube())};
  for (const double off : {1e-3, 1e-9}) {
    for (const Vector3d& x : {Vector3d(0.5, 0.1, 0.2), Vector3d(0.5, 0.5, 0.2), Vector3d(0.5, 0.5, 0.5)}) {
      CHECK(winding.at((1 - off) * x) == Approx(1).margin(1e-6));
      CHECK(winding.at((1 + off) * x) == Approx(0).margin(1e-6));
    }
  }
}

// Half a sphere seen from its centre covers half of all directions.
TEST_CASE("winding number: the solid angle of an open mesh") {
  PolygonSoup soup;
  const TriangleMesh ball{sphere(3)};
  soup.positions = ball.positions();
  for (const auto& [a, b, c] : ball.faces())
    if (ball.position(a).z() + ball.position(b).z() + ball.position(c).z() > 0) add_polygon(soup, {a, b, c});
  CHECK(WindingNumber{TriangleMesh(soup)}.at(Vector3d::Zero()) == Approx(0.5).margin(kDipoles));
}

TEST_CASE("face orientation: the smaller share is turned, one-sided surfaces are told") {
  const TriangleMesh ball{sphere(3)};
  const auto some = [](int f) { return f % 3 == 0; };
  const FaceOrientation found = orient_faces(reversed(ball, some));
  CHECK_FALSE(found.one_sided);
  for (std::int32_t f = 0; f < ball.face_count(); ++f)
    CHECK((found.turned[static_cast<std::size_t>(f)] != 0) == some(f));
  CHECK(found.turned_count == (ball.face_count() + 2) / 3);
  CHECK(orient_faces(TriangleMesh(grid(12, 2, Closing::kTwisted, false))).one_sided);
  CHECK_FALSE(orient_faces(TriangleMesh(grid(12, 2, Closing::kRound, false))).one_sided);
  CHECK(orient_faces(TriangleMesh(grid(12, 12, Closing::kTwisted, true))).one_sided);  // Klein bottle
}

}  // namespace leastcost::test
