// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace leastcost {

/// A promise that a part does not keep, with the worst number found and the limit it should have kept.
struct Fault {
  std::string name;     ///< one word, stable: "gradient", "symmetric", "retraction"
  std::string message;  ///< what was expected, where it was not found
  double measured = 0;  ///< the error that was found
  double allowed = 0;   ///< the largest one that is allowed
};

/// The faults a line each, "name: message (measured, allowed)"; empty when there are none.
std::string text(const std::vector<Fault>& faults);

/// A random point; the caller knows where his domain is.
using PointSampler = std::function<Eigen::VectorXd(std::mt19937_64&)>;

/// Uniform in the box lower..upper.
PointSampler sample_box(Eigen::VectorXd lower, Eigen::VectorXd upper);

}  // namespace leastcost
