// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
//
// Refraction in layers: docs/oracles.md D5, at every number of points.
#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_interfaces.hpp>
#include <leastcost/problems/costs/layers.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/fastest_refraction.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "framework/energy/spacing.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

const double kSnell = 2.01882163810130705, kSnellCrossing = 0.461735755834410626;
const double kHeadWave = 3 + std::numbers::sqrt3;
const double kFiveLayers = 4.1706021730313751;

std::shared_ptr<const LayersCost> layered(const Eigen::VectorXd& interfaces, const Eigen::VectorXd& speeds,
                                          int dim = 2) {
  LayersOptions options;
  options.interfaces = interfaces;
  options.speeds = speeds;
  return make_layers_cost(options, dim);
}

/// Speed 2 below the line y = 0, 1 above it.
std::shared_ptr<const LayersCost> two_layers() { return layered(Eigen::VectorXd::Zero(1), Eigen::Vector2d(2, 1)); }

/// As a configuration has it: no solver, refraction, and the proof unless `proof` is off.
Result refracted(const Problem& problem, int points, const Initializer& initializer = StraightInitializer(),
                 const GlobalProof& proof = GlobalAuto{}, const Solver& solver = NoSolver()) {
  FindOptions options;
  options.points = points;
  options.post_processors = {std::make_shared<const RefractPostProcessor>(),
                             std::make_shared<const FastestRefractionPostProcessor>(proof)};
  return find_path(problem, initializer, solver, options);
}

/// Certified, covered by its bar, global, equally spaced, with the points on the curve.
void check_result(const Result& result, double truth, int points) {
  CAPTURE(points, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.scope == Scope::global);
  CHECK(std::abs(result.certificate.estimate.value - truth) <= result.certificate.estimate.error);
  CHECK(std::abs(result.certificate.estimate.value / truth - 1) <= 2e-15);
  CHECK(result.certificate.estimate.error <= 1e-13 * truth);
  REQUIRE(result.certificate.global);
  CHECK(result.certificate.global->lower_bound <= truth);
  CHECK(result.path.free_count() == points);
  CHECK(spread(result.curve_costs) <= 1e-11);
  CHECK(result.curve_costs.sum() == Approx(truth).epsilon(1e-14));
}

}  // namespace

TEST_CASE("Snell's law in two layers, at every number of points", "[oracle]") {
  const Problem problem = between(space(2), two_layers(), Eigen::Vector2d(0, 1), Eigen::Vector2d(2, -1));
  for (int points = 1; points <= 100; ++points) {
    const Result result = refracted(problem, points);
    check_result(result, kSnell, points);
    REQUIRE(result.curve.x.cols() == 3);
    CHECK(result.curve.x(0, 1) == Approx(kSnellCrossing).epsilon(1e-13));
    CHECK(std::abs(result.curve.x(1, 1)) <= 1e-16);
  }
}

TEST_CASE("a head wave runs along the interface, at every number of points", "[oracle]") {
  const Problem problem = between(space(2), two_layers(), Eigen::Vector2d(0, 1), Eigen::Vector2d(6, 1));
  for (int points = 1; points <= 100; ++points) {
    const Result result = refracted(problem, points);
    check_result(result, kHeadWave, points);
    REQUIRE(result.curve.x.cols() == 4);
    CHECK(result.curve.x(0, 1) == Approx(1 / std::numbers::sqrt3).epsilon(1e-12));
    const auto crossings = find_ability<HasInterfaces>(*problem.cost)->crossings(result.curve.x, *problem.manifold);
    REQUIRE(crossings.size() == 2);
    CHECK(crossings[0].angle_before == Approx(std::numbers::pi / 6).epsilon(1e-12));
    CHECK(crossings[0].angle_after == Approx(std::numbers::pi / 2).epsilon(1e-12));
    CHECK(crossings[0].slowness == Approx(0.5).epsilon(1e-12));
  }
}

TEST_CASE("five layers, in the plane and in space", "[oracle]") {
  const Eigen::Vector4d interfaces(1, 2, 3, 4);
  Eigen::VectorXd speeds(5);
  speeds << 1, 1.5, 2, 2.5, 3;
  const Problem flat = between(space(2), layered(interfaces, speeds), Eigen::Vector2d(0, 0), Eigen::Vector2d(6, 5));
  check_result(refracted(flat, 30), kFiveLayers, 30);
  const Problem deep = between(space(3), layered(interfaces, speeds, 3), Eigen::Vector3d(1, 1, 0),
                               Eigen::Vector3d(1 + 6 * 0.6, 1 + 6 * 0.8, 5));
  check_result(refracted(deep, 31), kFiveLayers, 31);
}

/// Between the critical distance, where the path begins to touch the fast layer, and the crossover, from which on that
/// way is the faster one, both are locally least: 2 / sqrt 3 and 2 sqrt 3 for these layers.
TEST_CASE("the class is kept where it is asked for", "[oracle]") {
  const Problem problem = between(space(2), two_layers(), Eigen::Vector2d(0, 1), Eigen::Vector2d(2, 1));
  const WaypointsInitializer dip((Eigen::Matrix2Xd(2, 2) << 0.5, 1.5, -0.5, -0.5).finished());
  const Result head = refracted(problem, 20, dip, GlobalOff{});
  CHECK(head.status == Status::certified);
  CHECK(head.certificate.scope == Scope::least_of_class);
  CHECK(head.certificate.estimate.value == Approx(1 + std::numbers::sqrt3).epsilon(1e-14));
  const Result direct = refracted(problem, 20, dip);
  check_result(direct, 2, 20);
  CHECK(direct.certificate.global->outcome == ProofOutcome::improved);
  // Nearer than the critical distance nothing holds the path at the interface: the straight one is delivered.
  const Problem near = between(space(2), two_layers(), Eigen::Vector2d(0, 1), Eigen::Vector2d(0.5, 1));
  const Result straight = refracted(near, 20, dip, GlobalOff{});
  CHECK(straight.certificate.estimate.value == Approx(0.5).epsilon(1e-14));
}

TEST_CASE("ends on an interface: the lower index", "[oracle]") {
  const Eigen::Vector2d source(0, 0);
  check_result(refracted(between(space(2), two_layers(), source, Eigen::Vector2d(2, 0)), 9), 1, 9);
  // Along the interface and off it at the critical angle: x / 2 + h sqrt(1 - 1 / 4).
  check_result(refracted(between(space(2), two_layers(), source, Eigen::Vector2d(2, 0.5)), 9),
               1 + std::numbers::sqrt3 / 4, 9);
}

/// Solvers of chains take the cost as it is; their chains are not certified, whatever number of points.
TEST_CASE("a chain across interfaces is refused by name", "[oracle]") {
  const Problem problem = between(space(2), two_layers(), Eigen::Vector2d(0, 1), Eigen::Vector2d(2, -1));
  for (const int points : {20, 21}) {
    const Result result = find(problem, points);
    CHECK(result.status == Status::uncertified);
    REQUIRE_FALSE(result.certificate.failures.empty());
    CHECK(result.certificate.failures.front().name() == "interfaces");
    CHECK(result.curve.cost >= kSnell * (1 - 1e-14));
    CHECK(result.curve.cost <= kSnell * 1.01);
    check_result(refracted(problem, points, StraightInitializer(), GlobalAuto{}, Newton()), kSnell, points);
  }
}

TEST_CASE("layers outside of the box are out of reach", "[oracle]") {
  const Problem problem = between(box(Eigen::Vector2d(-1, 0.5), Eigen::Vector2d(7, 2)), two_layers(),
                                  Eigen::Vector2d(0, 1), Eigen::Vector2d(6, 1));
  check_result(refracted(problem, 10), 6, 10);  // the interface is outside: the straight path
}

TEST_CASE("refract says what it needs", "[oracle]") {
  const auto reason = [](const Problem& problem) -> std::string {
    try {
      const PostProcessed current{{}, {(Eigen::Matrix2Xd(2, 3) << 0, 1, 2, 1, 0, 1).finished(), {}, false}, {}, {}};
      RefractPostProcessor().apply(problem, {current.chain, {}, {}}, current, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const Eigen::Vector2d a(0, 1), b(2, 1);
  CHECK(reason(between(space(2), make_euclidean_cost(2), a, b)) == "refract needs a cost with layers");
  CHECK(reason(closed(space(2), two_layers())) == "refract joins two ends, but this path is a ring");
  CHECK(reason(between(space(2), two_layers(), a, b)).empty());
}

}  // namespace leastcost::test
