// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "framework/base/dense_solves.hpp"

namespace leastcost::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("dense solves: least squares meet the normal equations and are least where columns depend on each other") {
  MatrixXd a(4, 3);
  a << 1, 2, 0, 0, 1, 1, 3, 0, 1, 1, 1, 1;
  const MatrixXd b = MatrixXd::Identity(4, 2);
  const MatrixXd x = least_squares(a, b);
  CHECK((a.transpose() * (a * x - b)).norm() < 1e-14);
  MatrixXd twice(3, 2);
  twice << 1, 1, 2, 2, 0, 0;  // the same column twice: both get half
  const MatrixXd shared = least_squares(twice, VectorXd(Eigen::Vector3d(2, 4, 0)));
  CHECK(shared(0) == Approx(1));
  CHECK(shared(1) == Approx(1));
}

TEST_CASE("dense solves: the solution of least norm lies in the columns and there is none where they depend") {
  MatrixXd a(3, 2);
  a << 1, 0, 2, 1, 0, 3;
  const Eigen::Vector2d b(1, -2);
  const auto x = least_norm_solution(a, b, 1e-12);
  REQUIRE(x);
  CHECK((a.transpose() * *x - b).norm() < 1e-14);
  const MatrixXd inside = least_squares(a, *x);
  CHECK((a * inside - *x).norm() < 1e-14);
  a.col(1) = 2 * a.col(0);
  CHECK(!least_norm_solution(a, b, 1e-12));
}

TEST_CASE("dense solves: orthogonal factors span the columns first") {
  MatrixXd a(4, 2);
  a << 1, 0, 1, 1, 0, 2, 1, 0;
  const MatrixXd q = orthogonal_factor(a);
  CHECK((q.transpose() * q - MatrixXd::Identity(4, 4)).norm() < 1e-14);
  CHECK((q.rightCols(2).transpose() * a).norm() < 1e-14);
  MatrixXd dependent(3, 3);
  dependent << 1, 2, 1, 0, 0, 1, 1, 2, 1;
  const RankedFactor ranked = ranked_factor(dependent, 1e-9);
  CHECK(ranked.rank == 2);
  CHECK((ranked.q.col(2).transpose() * dependent).norm() < 1e-14);
}

TEST_CASE("dense solves: systems of symmetric matrices and their roots") {
  MatrixXd a(2, 2);
  a << 4, 1, 1, 3;
  const Eigen::Vector2d b(1, 2);
  CHECK((a * solve_symmetric(a, b) - b).norm() < 1e-14);
  const auto root = cholesky_factor(a);
  REQUIRE(root);
  CHECK((root->transpose() * *root - a).norm() < 1e-14);
  CHECK((*root)(1, 0) == 0);
  const auto inverse = inverse_of_definite(a);
  REQUIRE(inverse);
  CHECK((a * *inverse - MatrixXd::Identity(2, 2)).norm() < 1e-14);
  a(1, 1) = 0.2;  // one eigenvalue is negative
  CHECK(!cholesky_factor(a));
  CHECK(!inverse_of_definite(a));
}

}  // namespace leastcost::test
