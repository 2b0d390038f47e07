// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <leastcost/eigen_alignment.hpp>
#include "problems/bracket/cells/blocked_parts.hpp"
#include "problems/bracket/cells/dual_check.hpp"
#include "problems/bracket/cells/spline_check.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using namespace bracket;
using Eigen::Vector2d;

/// One cell of side 1 around the origin, and a disc that may cut it.
struct CutCell {
  Grid<2> grid{Vector2d(-1.5, -1.5), 1, {3, 3}, {Vector2d(-1.5, -1.5), Vector2d(1.5, 1.5)}};
  Vector2d center;
  double radius;

  explicit CutCell(Random& random)
      : center(random.uniform(-1, 1), random.uniform(-1, 1)), radius(random.uniform(0.1, 1.5)) {}
  double depth(const Vector2d& x) const { return radius - (x - center).norm(); }
  BlockedParts blocked() const {
    return {[this](const Vector2d& x) { return depth(x); }, grid, {2, 2}};
  }
  /// Those of the disc mirrored: an error that a test has to see.
  BlockedParts mirrored() const {
    return {[this](const Vector2d& x) { return depth({-x[0], x[1]}); }, grid, {2, 2}};
  }
};

/// Where n is 1, as a density and as a dual norm.
double proved_by_density(const Net<2>& u, const BlockedParts& blocked) {
  return proved_ratio<2>(u, 1, 4, net_of<2>(1), {}, blocked);
}
double proved_by_norm(const Net<2>& u, const BlockedParts& blocked) {
  const Quadratic one{.v = 1, .size = 1};
  return proved_dual_ratio(u, 1, 4, 1, {.xx = one, .xy = {}, .yy = one, .wx = {}, .wy = {}}, {}, blocked);
}

/// How often a ratio is said to be proved that the gradient exceeds at a place outside the disc.
template <class Prove, class Blocked>
int false_claims_beside_discs(Random& random, const Prove& prove, const Blocked& blocked_of) {
  int wrong = 0;
  for (int k = 0; k < 300; ++k) {
    const CutCell cell(random);
    Net<2> u;
    for (int n = 0; n < 9; ++n)
      u[static_cast<std::size_t>(n)] =
          0.9 * (n % 3) + (n / 3 == 2 ? random.uniform(0, 0.4) : 0) + 0.05 * random.normal();
    const double proved = prove(u, blocked_of(cell));
    double longest = 0;
    for (int q = 0; q <= 64; ++q)
      for (int p = 0; p <= 64; ++p) {
        const double a = p / 64.0 - 0.5, b = q / 64.0 - 0.5, small = 1e-6;
        if (cell.depth({a, b}) > 0) continue;
        const auto at = [&](double x, double y) { return spline_value<2>(u, std::array{x, y}); };
        longest =
            std::max(longest, std::hypot(at(a + small, b) - at(a - small, b), at(a, b + small) - at(a, b - small)) /
                                  (2 * small));
      }
    wrong += std::max(proved, 1.0) < longest - 1e-8 ? 1 : 0;
  }
  return wrong;
}

}  // namespace

TEST_CASE("bracket: blocked parts of a cell lie within obstacles, and few that do are missed") {
  Random random;
  int held = 0, within = 0;
  for (int k = 0; k < 300; ++k) {
    const CutCell cell(random);
    const BlockedParts blocked = cell.blocked();
    for (int level = 0; level <= BlockedParts::kLevels; ++level)
      for (int row = 0; row < 1 << level; ++row)
        for (int column = 0; column < 1 << level; ++column) {
          const double side = 1.0 / (1 << level);
          const Vector2d low(column * side - 0.5, row * side - 0.5);
          const double least = std::min({cell.depth(low), cell.depth(low + Vector2d(side, 0)),
                                         cell.depth(low + Vector2d(0, side)), cell.depth(low + Vector2d(side, side))});
          const bool holds = blocked.holds({level, {column, row}});
          REQUIRE((!holds || (least > 0 && blocked.any())));
          if (level != BlockedParts::kLevels) continue;
          held += holds ? 1 : 0;
          within += least > 0 ? 1 : 0;
        }
  }
  CHECK(held > 0.9 * within);
}

/// Nothing need be proved where no path is; the same parts, mirrored, would claim what does not hold.
TEST_CASE("bracket: the check of a cell beside an obstacle") {
  Random random;
  const auto blocked = [](const CutCell& cell) { return cell.blocked(); };
  const auto mirrored = [](const CutCell& cell) { return cell.mirrored(); };
  CHECK(false_claims_beside_discs(random, proved_by_density, blocked) == 0);
  CHECK(false_claims_beside_discs(random, proved_by_density, mirrored) > 10);
  CHECK(false_claims_beside_discs(random, proved_by_norm, blocked) == 0);
  CHECK(false_claims_beside_discs(random, proved_by_norm, mirrored) > 10);
}

}  // namespace leastcost::test
