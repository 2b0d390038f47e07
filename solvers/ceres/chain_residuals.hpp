// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/cost_function.h>
#include <ceres/evaluation_callback.h>

#include <exception>

#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {

/// The path whose columns Ceres moves, its residuals computed once for all segments.
class ChainResiduals final : public ceres::EvaluationCallback {
 public:
  ChainResiduals(PathEnergy& energy, const CoordinatePath& path) : energy_(energy), path_(path) {}

  double* point(Index column) { return path_.u.col(column).data(); }
  const CoordinatePath& path() const { return path_; }
  /// To be set where a move was stopped by a bound: the path is then not where the step leads, and is rejected.
  bool& stopped() { return stopped_; }
  /// Of the best path that was rejected for that reason; +infinity: there was none. It may be the better centre of the
  /// next round.
  double stopped_energy() const { return stopped_energy_; }
  const CoordinatePath& stopped_path() const { return stopped_path_; }
  /// What the problem's parts threw, if they did.
  std::exception_ptr thrown() const { return thrown_; }

  void PrepareForEvaluation(bool with_jacobians, bool new_point) override;
  bool evaluate(bool with_jacobians);

  /// Whether the last evaluation is one of a path that there is, finite.
  bool usable() const { return usable_; }
  const Points& values() const { return r_; }             ///< rows x N
  const Points& jacobians() const { return jacobians_; }  ///< rows x (2 coordinate N)

 private:
  PathEnergy& energy_;
  CoordinatePath path_, stopped_path_;
  Points r_, jacobians_;
  double stopped_energy_ = std::numeric_limits<double>::infinity();
  bool stopped_ = false, usable_ = false, have_jacobians_ = false;
  std::exception_ptr thrown_;
};

/// The residual of one segment, read from the common evaluation.
class SegmentResiduals final : public ceres::CostFunction {
 public:
  SegmentResiduals(const ChainResiduals& all, Index segment, int coordinates);
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const ChainResiduals& all_;
  Index segment_;
  int k_;
};

}  // namespace leastcost
