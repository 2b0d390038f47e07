// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/chain_system.hpp>

#include <Eigen/Dense>

#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// The matrix in full. In a ring of one the coupling joins x_0 with itself, in a ring of two both couplings join the
/// same pair.
Eigen::MatrixXd dense(const ChainSystem& system) {
  const int k = system.block();
  const Index n = system.count();
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(system.size(), system.size());
  for (Index i = 0; i < n; ++i) {
    m.block(k * i, k * i, k, k) += system.diagonal(i);
    const Index j = (i + 1) % n;
    if (i + 1 == n && !system.ring()) continue;
    m.block(k * i, k * j, k, k) += system.coupling(i);
    m.block(k * j, k * i, k, k) += system.coupling(i).transpose();
  }
  return m;
}

/// Random symmetric blocks; `shift` on the diagonal decides whether the whole is definite.
ChainSystem random_system(int k, Index n, bool ring, double shift, Random& random) {
  ChainSystem system;
  system.resize(k, n, ring);
  system.set_zero();
  for (Index i = 0; i < n; ++i) {
    const Eigen::MatrixXd a = random.matrix(k, k);
    system.diagonal(i) = (a + a.transpose()) / 2 + shift * Eigen::MatrixXd::Identity(k, k);
    if (i + 1 < n || ring) system.coupling(i) = random.matrix(k, k);
  }
  return system;
}

Index negatives(const Eigen::MatrixXd& m) {
  return (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues().array() < 0).count();
}

}  // namespace

TEST_CASE("chain system: multiply, factor and solve as the dense matrix does", "[framework]") {
  const int k = GENERATE(1, 2, 3, 4, 6, 7);
  const int n = GENERATE(1, 2, 3, 4, 9);
  const bool ring = GENERATE(false, true);
  CAPTURE(k, n, ring);
  Random random;
  ChainSystem system = random_system(k, n, ring, 6.0 + 3 * k, random);
  const Eigen::MatrixXd m = dense(system);
  REQUIRE(negatives(m) == 0);
  const Eigen::VectorXd x = random.vector(system.size());
  Eigen::VectorXd y;
  system.multiply(x, y);
  CHECK((y - m * x).norm() <= 1e-13 * (m * x).norm());
  REQUIRE(system.factor());
  Eigen::VectorXd solved = y;
  system.solve(solved);
  CHECK((solved - x).norm() <= 1e-12 * x.norm());
  CHECK(system.negative_eigenvalues() == 0);
}

TEST_CASE("chain system: negative eigenvalues of indefinite matrices, and factor() refuses them", "[framework]") {
  const int k = GENERATE(1, 2, 3, 4, 6, 7);
  const int n = GENERATE(1, 2, 3, 4, 12);
  const bool ring = GENERATE(false, true);
  Random random;
  for (const double shift : {-3.0, -0.5, 0.0, 0.5, 2.0, 4.0, -6.0 - 3 * k}) {
    CAPTURE(k, n, ring, shift);
    ChainSystem system = random_system(k, n, ring, shift, random);
    const Index expected = negatives(dense(system));
    CHECK(system.negative_eigenvalues() == expected);
    CHECK(system.factor() == (expected == 0));
    const Eigen::VectorXd down = system.negative_direction();
    CHECK((down.size() > 0) == (expected > 0));
    if (down.size() > 0) CHECK(down.dot(dense(system) * down) < 0);
  }
}

TEST_CASE("chain system: one system serves different sizes, and add() adds", "[framework]") {
  Random random;
  ChainSystem system = random_system(3, 8, true, 20, random);
  CHECK(system.factor());
  system.resize(2, 5, false);
  system.set_zero();
  for (Index i = 0; i < 5; ++i) system.diagonal(i).setIdentity();
  const ChainSystem other = random_system(2, 5, false, 0, random);
  const Eigen::MatrixXd expected = Eigen::MatrixXd::Identity(10, 10) - 0.25 * dense(other);
  system.add(-0.25, other);
  CHECK((dense(system) - expected).cwiseAbs().maxCoeff() <= 1e-15);
}

TEST_CASE("chain system: what is not finite does not factor", "[framework]") {
  Random random;
  const bool ring = GENERATE(false, true);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    ChainSystem system = random_system(2, 4, ring, 20, random);
    system.diagonal(2)(0, 0) = bad;
    CHECK_FALSE(system.factor());
    system = random_system(2, 4, ring, 20, random);
    system.coupling(1)(1, 0) = bad;
    CHECK_FALSE(system.factor());
  }
}

}  // namespace leastcost::test
