// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/ceres/chain_residuals.hpp"

namespace leastcost {

void ChainResiduals::PrepareForEvaluation(bool with_jacobians, bool new_point) {
  if (!new_point && (!with_jacobians || have_jacobians_)) return;
  if (new_point) energy_.count({.projections = 1});  // by PointManifold::Plus, point by point
  if (!stopped_) {
    evaluate(with_jacobians);
    return;
  }
  stopped_ = usable_ = false;
  try {
    Points gradient;  // a path without a finite one could not be the centre of a round
    const double value = energy_.value_and_gradient(path_, gradient);
    if (!(value < stopped_energy_)) return;
    stopped_energy_ = value;
    stopped_path_ = path_;
  } catch (...) {
    thrown_ = std::current_exception();
  }
}

bool ChainResiduals::evaluate(bool with_jacobians) {
  usable_ = false;
  have_jacobians_ = with_jacobians;
  try {
    energy_.residuals(path_, r_, with_jacobians ? &jacobians_ : nullptr);
    usable_ = r_.allFinite() && (!with_jacobians || jacobians_.allFinite());
  } catch (...) {
    thrown_ = std::current_exception();
  }
  return usable_;
}

SegmentResiduals::SegmentResiduals(const ChainResiduals& all, Index segment, int coordinates)
    : all_(all), segment_(segment), k_(coordinates) {
  set_num_residuals(static_cast<int>(all.values().rows()));
  *mutable_parameter_block_sizes() = {coordinates, coordinates};
}

bool SegmentResiduals::Evaluate(double const* const*, double* residuals, double** jacobians) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  if (!all_.usable()) return false;
  const Index rows = all_.values().rows();
  Eigen::Map<Eigen::VectorXd>(residuals, rows) = all_.values().col(segment_);
  if (jacobians == nullptr) return true;
  for (int end = 0; end < 2; ++end)
    if (jacobians[end] != nullptr)
      Eigen::Map<RowMajor>(jacobians[end], rows, k_) = all_.jacobians().middleCols(2 * k_ * segment_ + k_ * end, k_);
  return true;
}

}  // namespace leastcost
