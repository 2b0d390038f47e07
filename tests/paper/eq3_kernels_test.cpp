// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Eq. (3), Sec. 3.1: any H with H' > 0, H'' >= 0 has the critical points of the length. All six kernels find one
// path.
#include "tests/support/catch.hpp"
#include "tests/support/chute_chain.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

const std::pair<const char*, std::shared_ptr<const Kernel>> kStrict[] = {
    {"s^2", make_kernel<Square>()},         {"exp(s^2) - 1", make_kernel<Expm1Square>()},
    {"exp(s^2)", make_kernel<ExpSquare>()}, {"exp(s)", make_kernel<Exp>()},
    {"exp(s) - 1", make_kernel<Expm1>()},
};

}  // namespace

TEST_CASE("Eq. 3: every strictly convex kernel gives the same chain of chutes", "[paper]") {
  for (const auto& [name, kernel] : kStrict) {
    CAPTURE(name);
    const Result result =
        find(bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1), 1, 0, TravelTimeRule::chute, kernel), 20);
    CHECK(result.costs.sum() == Approx(chute_chain_time(2, 1, 1, 21)).epsilon(1e-9));
    CHECK(spread(result.costs) < 1e-6);
    CHECK(result.status == Status::certified);
  }
}

TEST_CASE("Eq. 3: every strictly convex kernel gives the great circle", "[paper]") {
  const Eigen::Vector3d from(1, 0, 0), to = Eigen::Vector3d(-1, 2, 1).normalized();
  for (const auto& [name, kernel] : kStrict) {
    CAPTURE(name);
    const Result result = find(between(std::make_shared<Sphere>(), make_euclidean_cost(3), from, to, kernel), 15);
    const double angle = std::acos(from.dot(to));
    CHECK(result.costs.sum() == Approx(32 * std::sin(angle / 32)).epsilon(1e-12));
    CHECK(spread(result.costs) < 1e-6);
    CHECK(result.status == Status::certified);
  }
}

TEST_CASE("Eq. 3: H = s finds the length as well, but no spacing, and its certificate says so", "[paper]") {
  const Problem problem =
      between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 4), make_kernel<Linear>());
  const Result result = find(problem, 20, WaypointsInitializer(Eigen::Vector2d(3, 0)));
  CAPTURE(failures(result.certificate), result.costs.sum());
  CHECK(result.costs.sum() == Approx(5).epsilon(1e-6));
  CHECK(result.status == Status::uncertified);
  CHECK(failed(result.certificate, "index_not_applicable"));
}

}  // namespace leastcost::test
