// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Eq. (10) and its cases (a), (b), (c): the gradient of E at s0 = 1.
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Term = Eigen::VectorXd (*)(const Eigen::VectorXd& to_next);  ///< x_i - x_j -> its part of the gradient at x_i

void check(const std::shared_ptr<const Kernel>& kernel, Term term) {
  Random random;
  for (const int d : {2, 3, 7}) {
    const Problem problem{space(d), make_euclidean_cost(d), kernel, {}, {}, false};
    const CoordinatePath path{0.5 * random.matrix(d, 9), {}, false};
    PathEnergy energy(problem, 1);
    Points gradient;
    energy.value_and_gradient(path, gradient);
    REQUIRE(gradient.cols() == 7);
    for (Index i = 1; i < 8; ++i) {
      const Eigen::VectorXd paper = term(path.u.col(i) - path.u.col(i + 1)) + term(path.u.col(i) - path.u.col(i - 1));
      CHECK((gradient.col(i - 1) - paper).norm() <= 1e-13 * paper.norm() + 1e-13);
    }
  }
}

}  // namespace

TEST_CASE("Eq. 10 (a): H = s", "[paper]") {
  check(make_kernel<Linear>(), [](const Eigen::VectorXd& d) -> Eigen::VectorXd { return d / d.norm(); });
}
TEST_CASE("Eq. 10 (b): H = s^2", "[paper]") {
  check(make_kernel<Square>(), [](const Eigen::VectorXd& d) -> Eigen::VectorXd { return 2 * d; });
}
TEST_CASE("Eq. 10 (c): H = exp(s^2) - 1", "[paper]") {
  check(make_kernel<Expm1Square>(),
        [](const Eigen::VectorXd& d) -> Eigen::VectorXd { return 2 * std::exp(d.squaredNorm()) * d; });
}
TEST_CASE("Eq. 10: H'(|d|) d / |d| for the others", "[paper]") {
  check(make_kernel<ExpSquare>(),
        [](const Eigen::VectorXd& d) -> Eigen::VectorXd { return 2 * std::exp(d.squaredNorm()) * d; });
  check(make_kernel<Exp>(),
        [](const Eigen::VectorXd& d) -> Eigen::VectorXd { return std::exp(d.norm()) * d / d.norm(); });
  check(make_kernel<Expm1>(),
        [](const Eigen::VectorXd& d) -> Eigen::VectorXd { return std::exp(d.norm()) * d / d.norm(); });
}

TEST_CASE("Eq. 10 has 0 / 0 at coincident points, in q = s^2 nothing of the kind", "[paper]") {
  for (const auto& kernel : {make_kernel<Square>(), make_kernel<Expm1Square>(), make_kernel<ExpSquare>(),
                             make_kernel<Linear>(), make_kernel<Exp>(), make_kernel<Expm1>()}) {
    const Problem problem{space(2), make_euclidean_cost(2), kernel, {}, {}, false};
    const CoordinatePath path{(Points(2, 4) << 0, 1, 1, 2, 0, 0, 0, 1).finished(), {}, false};
    PathEnergy energy(problem, 1);
    Points gradient;
    CHECK(std::isfinite(energy.value_and_gradient(path, gradient)));
    CHECK(gradient.allFinite());
  }
}

}  // namespace leastcost::test
