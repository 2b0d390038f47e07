// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Fig. 3: random trees in the shell around a plane curve and around a sphere as first paths.
#include <cmath>
#include <numbers>

#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include "problems/level_set/named_surfaces.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

const int kSeeds = nightly() ? 12 : 4;

std::shared_ptr<const LevelSet> surface(const char* name) {
  return make_implicit_manifold({.surface = form<implicit::Surface>(name)});
}

Result from_tree(const Problem& problem, int points, int seed) {
  RrtOptions options;
  options.step = 0.2;
  options.shell = 0.1;
  options.seed = seed;
  return find(problem, points, RrtInitializer(options));
}

/// Runs along the curve f = 0 from `from` (fourth-order Runge-Kutta in the arc length) until it passes `to`; the way so
/// far.
double arc_length(const ConstraintFunction& f, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double sense) {
  const auto tangent = [&](const Eigen::Vector2d& x) {
    Eigen::VectorXd value(1);
    Points gradient(2, 1);
    f.evaluate(x, value, gradient);
    return Eigen::Vector2d(sense * Eigen::Vector2d(-gradient(1), gradient(0)).normalized());
  };
  constexpr double kStep = 1e-3;
  Eigen::Vector2d x = from;
  double length = 0;
  for (; length < 100; length += kStep) {
    const Eigen::Vector2d a = tangent(x), left = to - x;
    if (left.norm() < 2 * kStep && left.dot(a) < kStep) return length + left.norm();
    const Eigen::Vector2d b = tangent(x + kStep / 2 * a), c = tangent(x + kStep / 2 * b), d = tangent(x + kStep * c);
    x += kStep / 6 * (a + 2 * b + 2 * c + d);
  }
  return length;
}

}  // namespace

TEST_CASE("VFCS Fig. 3c: a random tree around a closed curve finds one of its two arcs", "[paper]") {
  const auto curve = surface("paper_curve");
  const Problem problem = between(curve, make_euclidean_cost(2), Eigen::Vector2d(-1.5, 1), Eigen::Vector2d(1, -3));
  const double one_way = arc_length(curve->function(), problem.source.u, problem.target.u, 1);
  const double other_way = arc_length(curve->function(), problem.source.u, problem.target.u, -1);
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Result result = from_tree(problem, 200, seed);
    const CostEstimate& estimate = result.certificate.estimate;
    CAPTURE(seed, one_way, other_way, estimate.value, estimate.error, failures(result.certificate));
    CHECK(result.status == Status::certified);
    const double off = std::min(std::abs(estimate.value - one_way), std::abs(estimate.value - other_way));
    CHECK(off <= estimate.error + 1e-9);  // the arc length is good to its last, straight piece: 1e-3 ^ 3
  }
}

TEST_CASE("VFCS Fig. 3d: a random tree on a sphere, solved, is an arc of the great circle", "[paper]") {
  const double shorter = std::acos(-0.8);
  const Problem problem =
      between(surface("sphere"), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-0.8, 0.6, 0));
  int certified = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Result result = from_tree(problem, 60, seed);
    const CostEstimate& estimate = result.certificate.estimate;
    const bool is_short = result.status == Status::certified;
    CAPTURE(seed, estimate.value, failures(result.certificate));
    CHECK(std::abs(estimate.value - (is_short ? shorter : 2 * kPi - shorter)) <= estimate.error + 1e-14);
    certified += is_short ? 1 : 0;
  }
  CHECK(certified >= kSeeds - kSeeds / 6);  // a tree may lead around the far side: a saddle, and said to be one
}

}  // namespace leastcost::test
