// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/pose_domain.hpp"

#include <algorithm>
#include <utility>

namespace leastcost {
namespace {

constexpr Index kNumbers = 4;       ///< of a quaternion
constexpr double kShortest = 1e-6;  ///< of their length

}  // namespace

PoseDomain::PoseDomain(int rows, std::vector<Index> quaternions, double length)
    : EmbeddedManifold({rows, rows, rows - static_cast<int>(quaternions.size())}),
      quaternions_(std::move(quaternions)),
      length_(length) {}

bool PoseDomain::project_point(Eigen::Ref<Eigen::VectorXd> x) const {
  const auto short_one = [&](Index row) { return !(x.segment<kNumbers>(row).norm() > kShortest * length_); };
  if (std::any_of(quaternions_.begin(), quaternions_.end(), short_one)) return false;
  for (const Index row : quaternions_) x.segment<kNumbers>(row) *= length_ / x.segment<kNumbers>(row).norm();
  return true;
}

/// At a quaternion q the products iq, jq, kq: three directions of length one, at right angles to it and each other.
void PoseDomain::tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const {
  basis.setZero();
  Index column = 0;
  auto next = quaternions_.begin();
  for (Index row = 0; row < x.size();) {
    if (next == quaternions_.end() || row != *next) {
      basis(row++, column++) = 1;
      continue;
    }
    const Eigen::Vector4d q = x.segment<kNumbers>(row) / length_;
    basis.block<kNumbers, 3>(row, column) << q[3], q[2], -q[1],  //
        -q[2], q[3], q[0],                                       //
        q[1], -q[0], q[3],                                       //
        -q[0], -q[1], -q[2];
    row += kNumbers;
    column += 3;
    ++next;
  }
}

}  // namespace leastcost
