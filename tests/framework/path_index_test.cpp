// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Morse index by pivots, docs/numerics.md Sec. 6.4: the first negative pivot is the conjugate point.
#include <leastcost/framework/path_index.hpp>

#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

/// n + 1 equal chords of a great circle over an angle; a ring of n for the whole circle.
CoordinatePath arc(double angle, int segments, bool ring = false) {
  CoordinatePath path{Points(3, ring ? segments : segments + 1), {}, ring};
  for (Index i = 0; i < path.u.cols(); ++i) {
    const double t = angle * static_cast<double>(i) / segments;
    path.u.col(i) << std::cos(t), std::sin(t) * 0.8, std::sin(t) * 0.6;
  }
  return path;
}

PathIndex index_on(std::shared_ptr<const ConstraintManifold> manifold, const CoordinatePath& path,
                   const std::shared_ptr<const Kernel>& kernel = make_kernel<Expm1Square>()) {
  const int d = manifold->dimensions().ambient;
  const Problem problem{std::move(manifold), make_euclidean_cost(d), kernel, {}, {}, path.ring};
  PathEnergy energy(problem, PathEnergy(problem, 1).cost(path) / static_cast<double>(path.segment_count()));
  return path_index(energy, path, 1e-3);
}

}  // namespace

TEST_CASE("index of a great-circle arc of length L is floor(L / pi)", "[framework]") {
  const int segments = GENERATE(16, 64, 200);
  const bool square = GENERATE(true, false);
  const auto kernel = square ? make_kernel<Square>() : make_kernel<Expm1Square>();
  for (double length = 0.1 * kPi; length < 3 * kPi; length += 0.2 * kPi) {
    const PathIndex index = index_on(std::make_shared<Sphere>(), arc(length, segments), kernel);
    CAPTURE(segments, length / kPi, index.negatives, index.nullity);
    const int expected = static_cast<int>(length / kPi);
    CHECK(index.negatives == expected);
    CHECK(index.saddle_order == expected);
    CHECK(index.verdict == (expected > 0 ? IndexVerdict::saddle : IndexVerdict::minimum));
  }
}

TEST_CASE("index at the conjugate point itself: degenerate", "[framework]") {
  const PathIndex index = index_on(std::make_shared<Sphere>(), arc(kPi, 64));
  CHECK(index.verdict == IndexVerdict::degenerate);
  CHECK(index.nullity == 1);
}

TEST_CASE("index of a whole great circle: a saddle", "[framework]") {
  const PathIndex index = index_on(std::make_shared<Sphere>(), arc(2 * kPi, GENERATE(16, 64), true));
  CAPTURE(index.negatives, index.nullity);
  CHECK(index.verdict == IndexVerdict::saddle);
  CHECK(index.saddle_order >= 1);  // sinking to a small circle; tilting costs nothing to second order
}

TEST_CASE("index of a straight line is 0 in any dimension; H = s has none", "[framework]") {
  const int d = GENERATE(2, 3, 7);
  CoordinatePath line{Points(d, 21), {}, false};
  for (Index i = 0; i < 21; ++i) line.u.col(i).setConstant(0.1 * static_cast<double>(i));
  const PathIndex index = index_on(space(d), line);
  CHECK((index.verdict == IndexVerdict::minimum && index.negatives == 0 && index.nullity == 0));
  CHECK(index_on(space(d), line, make_kernel<Linear>()).verdict == IndexVerdict::not_applicable);
}

}  // namespace leastcost::test
