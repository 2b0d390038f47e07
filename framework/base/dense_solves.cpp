// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/base/dense_solves.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace leastcost {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Given = Eigen::Ref<const MatrixXd>;

MatrixXd least_squares(const Given& a, const Given& b) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(a).solve(b);
}

std::optional<VectorXd> least_norm_solution(const Given& a, const Eigen::Ref<const VectorXd>& b, double threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(a);
  qr.setThreshold(threshold);
  const Eigen::Index k = a.cols();
  if (qr.rank() < k) return std::nullopt;
  VectorXd x = VectorXd::Zero(a.rows());
  x.head(k) = qr.colsPermutation().transpose() * b;
  qr.matrixR().topLeftCorner(k, k).triangularView<Eigen::Upper>().transpose().solveInPlace(x.head(k));
  x.applyOnTheLeft(qr.householderQ());
  return x;
}

MatrixXd orthogonal_factor(const Given& a) { return Eigen::HouseholderQR<MatrixXd>(a).householderQ(); }

RankedFactor ranked_factor(const Given& a, double least) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(a);
  RankedFactor out{qr.householderQ(), 0};
  const auto most = static_cast<int>(std::min(a.rows(), a.cols()));
  while (out.rank < most && std::abs(qr.matrixR()(out.rank, out.rank)) > least) ++out.rank;
  return out;
}

MatrixXd solve_symmetric(const Given& a, const Given& b) { return Eigen::LDLT<MatrixXd>(a).solve(b); }

std::optional<MatrixXd> cholesky_factor(const Given& a) {
  const Eigen::LLT<MatrixXd> llt(a);
  if (llt.info() != Eigen::Success) return std::nullopt;
  return MatrixXd(llt.matrixU());
}

std::optional<MatrixXd> inverse_of_definite(const Given& a) {
  const Eigen::LLT<MatrixXd> llt(a);
  if (llt.info() != Eigen::Success) return std::nullopt;
  return MatrixXd(llt.solve(MatrixXd::Identity(a.rows(), a.cols())));
}

}  // namespace leastcost
