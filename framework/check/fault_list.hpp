// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/check/faults.hpp>

namespace leastcost {

/// Throws InputError for a point of another dimension.
void check_dimension(const Eigen::VectorXd& point, Eigen::Index dimension);

/// The sampler, whose points are looked at; throws InputError where there is none.
PointSampler of_dimension(const PointSampler& sampler, Eigen::Index dimension);

/// Faults by name, each with its worst number.
class FaultList {
 public:
  /// measured <= allowed, or a fault. NaN is one.
  void at_most(const char* name, double measured, double allowed, const std::string& message) {
    if (!(measured <= allowed)) add({name, message, measured, allowed}, measured - allowed);
  }
  void at_least(const char* name, double measured, double allowed, const std::string& message) {
    if (!(measured >= allowed)) add({name, message, measured, allowed}, allowed - measured);
  }
  std::vector<Fault> take() { return std::move(faults_); }

 private:
  void add(Fault fault, double excess) {
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      if (faults_[i].name != fault.name) continue;
      if (excess > excess_[i]) faults_[i] = std::move(fault), excess_[i] = excess;
      return;
    }
    faults_.push_back(std::move(fault));
    excess_.push_back(excess);
  }

  std::vector<Fault> faults_;
  std::vector<double> excess_;
};

inline Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(engine); });
}

}  // namespace leastcost
