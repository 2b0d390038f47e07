// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/segment_blocks.hpp>

#include <Eigen/Eigenvalues>

namespace leastcost::detail {
namespace {

template <class Matrix>
void lift(Eigen::Ref<Points> h) {
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(h);
  const double floor = 1e-9 * eigen.eigenvalues().cwiseAbs().maxCoeff();
  h = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(floor).asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

/// No heap up to R^8; by far the most are costs in the plane and in space.
void lift_eigenvalues(Eigen::Ref<Points> h) {
  constexpr int kMost = 16;
  if (h.rows() == 4)
    lift<Eigen::Matrix4d>(h);
  else if (h.rows() == 6)
    lift<Eigen::Matrix<double, 6, 6>>(h);
  else if (h.rows() <= kMost)
    lift<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>>(h);
  else
    lift<Eigen::MatrixXd>(h);
}

void chord_residual(const ConstVector& a, const ConstVector& b, double q, const ConstVector* ga, const ConstVector* gb,
                    Eigen::Ref<Eigen::VectorXd> r, Eigen::Ref<Points> jacobian) {
  const Index d = a.size();
  const double cost = std::sqrt(q), length = (b - a).norm();
  r.setZero();
  jacobian.setZero();
  if (!(length > 0) || !(cost > 0)) return;
  const Eigen::VectorXd direction = (b - a) / length;
  r = cost * direction;
  const auto add = [&](const ConstVector& slope, double sign, Index column) {
    auto columns = jacobian.middleCols(column, d);
    columns = direction * slope.transpose() / (2 * cost) - sign * cost / length * direction * direction.transpose();
    columns.diagonal().array() += sign * cost / length;
  };
  if (ga != nullptr) add(*ga, -1, 0);
  if (gb != nullptr) add(*gb, 1, d);
}

}  // namespace leastcost::detail
