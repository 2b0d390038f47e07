// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/base/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

namespace leastcost {

Eigen::MatrixXd SymmetricEigen::with_values(const Eigen::VectorXd& others) const {
  return vectors * others.asDiagonal() * vectors.transpose();
}

SymmetricEigen symmetric_eigen(const Eigen::Ref<const Eigen::MatrixXd>& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(m);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace leastcost
