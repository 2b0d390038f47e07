// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Eq. (8) and Sec. 4.2.2: what doubling the points does to the energy, by the kind of kernel; and the sinkhole it
// detects.
#include <cstdio>

#include "framework/energy/spacing.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"
#include "tests/support/trench.hpp"

namespace leastcost::test {
namespace {

/// E_1 / E_2 at one s0, which is large against the segments so that the limit s -> 0 of the paper is meant.
double doubling_ratio(const Problem& problem, CoordinatePath path, double s0) {
  PathEnergy energy(problem, s0);
  const Newton newton;
  newton.solve(energy, path, {});
  const double coarse = energy.value(path);
  path = refine(problem, path);
  newton.solve(energy, path, {});
  return coarse / energy.value(path);
}

Problem on_sphere(const std::shared_ptr<const Kernel>& kernel) {
  return between(std::make_shared<Sphere>(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0),
                 Eigen::Vector3d(-0.4, 0.8, 0.6), kernel);
}

}  // namespace

TEST_CASE("Eq. 8: E1 / E2 is 1/2, 1, 2 by the kind of the kernel", "[paper]") {
  struct Row {
    const char* name;
    std::shared_ptr<const Kernel> kernel;
    double ratio;
  };
  const Row rows[] = {{"exp(s)", make_kernel<Exp>(), 0.5},
                      {"exp(s^2)", make_kernel<ExpSquare>(), 0.5},
                      {"exp(s) - 1", make_kernel<Expm1>(), 1},
                      {"s^2", make_kernel<Square>(), 2},
                      {"exp(s^2) - 1", make_kernel<Expm1Square>(), 2}};
  for (const Row& row : rows) {
    const Problem problem = on_sphere(row.kernel);
    const CoordinatePath start = sample_equally(problem, StraightInitializer().first_path(problem, {}).path, 63);
    const double s0 = 30 * PathEnergy(problem, 1).cost(start) / 64;  // s = 1/30
    const double ratio = doubling_ratio(problem, start, s0);
    std::printf("Eq. 8: %-12s E1 / E2 = %.4f, limit %.1f\n", row.name, ratio, row.ratio);
    CHECK(ratio == Approx(row.ratio).epsilon(0.02));  // s / 4 and 3 s^2 / 4 are what separates s from its limit
  }
}

TEST_CASE(
    "Eq. 8: at s near 1 the limit does not apply to exp(s^2) - 1: the certificate compares with H(s) / (2 H(s / 2))",
    "[paper]") {
  const Result result = find(on_sphere(make_kernel<Expm1Square>()), 31);
  REQUIRE(result.certificate.doubling);
  CHECK(*result.certificate.doubling > 2.5);
  CHECK(*result.certificate.doubling == Approx(*result.certificate.doubling_expected).epsilon(1e-3));
  CHECK(result.status == Status::certified);
}

TEST_CASE("Eq. 8, Fig. 2: a path that jumps over a trench has a ratio far below 2", "[paper]") {
  const Trench gentle(2, 0.5), steep(4, 0.4);
  const double good = doubling_ratio(gentle.problem(make_kernel<Square>()), gentle.through(511), 1);
  const double bad = doubling_ratio(steep.problem(make_kernel<Square>()), steep.jumping(63), 1);
  std::printf("Eq. 8: through the trench %.3f, over it (a sinkhole) %.3f\n", good, bad);
  CHECK(good == Approx(2).epsilon(0.05));
  CHECK(bad < 1.7);
}

}  // namespace leastcost::test
