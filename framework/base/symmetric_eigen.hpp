// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace leastcost {

/// m = vectors diag(values) vectors'. Eigen's solver is compiled here once for all: each use takes seconds elsewhere,
/// and fixed sizes gain a quarter of the run time for 4 x 4, nothing for 6 x 6.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< orthonormal columns

  /// vectors diag(others) vectors'.
  Eigen::MatrixXd with_values(const Eigen::VectorXd& others) const;
};

SymmetricEigen symmetric_eigen(const Eigen::Ref<const Eigen::MatrixXd>& m);

/// The values alone, ascending.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& m);

}  // namespace leastcost
