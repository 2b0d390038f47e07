// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/string_program.hpp"

#include "framework/newton/chain_program.hpp"

namespace leastcost {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

Matrix3Xd least_stretched(const Matrix3Xd& x, const VectorXd& rest, const std::vector<HalfSpace>& half_spaces,
                          const Matrix3Xd& pull) {
  const Index m = x.cols() - 2;
  if (m < 1) return x;
  ChainSystem springs;
  springs.resize(3, m, false);
  springs.set_zero();
  Matrix3Xd force = pull.size() > 0 ? Matrix3Xd(pull.middleCols(1, m)) : Matrix3Xd::Zero(3, m);
  for (Index i = 0; i < m; ++i) {
    springs.diagonal(i).diagonal().setConstant(1 / rest[i] + 1 / rest[i + 1]);
    if (i + 1 < m) springs.coupling(i).diagonal().setConstant(-1 / rest[i + 1]);
  }
  force.col(0) += x.col(0) / rest[0];
  force.col(m - 1) += x.col(m + 1) / rest[m];
  ChainHalfSpaces rows(3);
  for (const HalfSpace& h : half_spaces) rows.add(h.vertex - 1, h.normal, h.offset);
  const auto z = least_of_chain(springs, force.reshaped(), rows, x.middleCols(1, m).reshaped());
  Matrix3Xd y = x;
  if (z) y.middleCols(1, m) = z->reshaped(3, m);
  return y;
}

}  // namespace leastcost
