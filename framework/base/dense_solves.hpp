// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

namespace leastcost {

/// Systems of linear equations of any size. Eigen's decompositions are compiled here once for all: each use of one
/// takes seconds elsewhere. Where points are many and their dimension is known, a decomposition of fixed size is
/// quicker.

/// The x of least |x| among those of least |a x - b|, for each column of b.
Eigen::MatrixXd least_squares(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b);

/// The x of least |x| with a' x = b. None where the columns of a are dependent: a pivot is at most `threshold` times
/// the largest.
std::optional<Eigen::VectorXd> least_norm_solution(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                                   const Eigen::Ref<const Eigen::VectorXd>& b, double threshold);

/// The square Q of a = Q R: where the columns of a are independent they span what the first ones of Q span, and the
/// others are across.
Eigen::MatrixXd orthogonal_factor(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// As orthogonal_factor(), where columns of a may depend on each other: the first `rank` columns span them.
struct RankedFactor {
  Eigen::MatrixXd q;
  int rank = 0;  ///< pivots above `least`
};
RankedFactor ranked_factor(const Eigen::Ref<const Eigen::MatrixXd>& a, double least);

/// a x = b for a symmetric, semidefinite a.
Eigen::MatrixXd solve_symmetric(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b);

/// The upper triangular U with U'U = a; none where the symmetric a is not positive definite.
std::optional<Eigen::MatrixXd> cholesky_factor(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// The inverse of a symmetric a; none where it is not positive definite.
std::optional<Eigen::MatrixXd> inverse_of_definite(const Eigen::Ref<const Eigen::MatrixXd>& a);

}  // namespace leastcost
