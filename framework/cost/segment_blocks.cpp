// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/cost/segment_blocks.hpp>

#include "framework/base/symmetric_eigen.hpp"

namespace leastcost::detail {

void lift_eigenvalues(Eigen::Ref<Points> h) {
  const SymmetricEigen eigen = symmetric_eigen(h);
  const double floor = 1e-9 * eigen.values.cwiseAbs().maxCoeff();
  h = eigen.with_values(eigen.values.cwiseMax(floor));
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

namespace leastcost {

template void segment_chain_blocks(const SegmentFunction<2>&, const AmbientPath&, const Kernel&, double, HessianKind,
                                   int, ChainBlocks&);
template void segment_residuals(const SegmentFunction<2>&, const AmbientPath&, int, Points&, Points*);
template void segment_chain_blocks(const SegmentFunction<3>&, const AmbientPath&, const Kernel&, double, HessianKind,
                                   int, ChainBlocks&);
template void segment_residuals(const SegmentFunction<3>&, const AmbientPath&, int, Points&, Points*);
template void segment_chain_blocks(const SegmentFunction<Eigen::Dynamic>&, const AmbientPath&, const Kernel&, double,
                                   HessianKind, int, ChainBlocks&);
template void segment_residuals(const SegmentFunction<Eigen::Dynamic>&, const AmbientPath&, int, Points&, Points*);

}  // namespace leastcost
