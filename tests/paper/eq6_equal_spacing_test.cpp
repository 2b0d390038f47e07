// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Eqs. (4), (6), (7): Jensen's inequality. N H(C / N) <= sum H(c_i), equal exactly for equal segments.
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// sum H(c_i / s0) - N H(mean c / s0)
double jensen_gap(const Problem& problem, const CoordinatePath& path, double s0) {
  PathEnergy energy(problem, s0);
  const double n = static_cast<double>(path.segment_count());
  return energy.value(path) - n * kernel_value(*problem.kernel, energy.cost(path) / (n * s0));
}

const std::shared_ptr<const Kernel> kKernels[] = {make_kernel<Square>(), make_kernel<Expm1Square>(),
                                                  make_kernel<ExpSquare>(), make_kernel<Exp>(), make_kernel<Expm1>()};

}  // namespace

TEST_CASE("Eq. 6: the gap of Jensen's inequality is positive, and zero for equal segments", "[paper]") {
  Random random;
  for (const auto& kernel : kKernels) {
    const Problem problem =
        between(space(3), make_euclidean_cost(3), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 1, 2), kernel);
    CoordinatePath path{random.matrix(3, 12), {}, false};
    CHECK(jensen_gap(problem, path, 1) > 0);
    for (Index i = 0; i < 12; ++i) path.u.col(i) = problem.target.u * static_cast<double>(i) / 11;
    CHECK(std::abs(jensen_gap(problem, path, 1)) < 1e-12 * PathEnergy(problem, 1).value(path));
    path.u.col(4) += 1e-3 * (path.u.col(5) - path.u.col(4));  // slid along the line: same length, larger energy
    CHECK(jensen_gap(problem, path, 1) > 1e-8);
  }
}

TEST_CASE("Eq. 7: at a minimum of E the gap closes and the points are equally spaced in cost", "[paper]") {
  for (const auto& kernel : kKernels) {
    const Problem problem = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1), 1, 0, TravelTimeRule::chute, kernel);
    const Result result = find(problem, 30);
    CHECK(spread(result.costs) < 1e-6);
    CHECK(std::abs(jensen_gap(problem, result.path, result.reference_cost)) < 1e-12 * result.solve.final_energy);
    CHECK(jensen_gap(problem, result.initial, result.reference_cost) > 1e-6);  // before: only nearly equal
  }
}

}  // namespace leastcost::test
