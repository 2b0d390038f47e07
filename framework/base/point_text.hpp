// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

namespace leastcost {

/// "(1, 2.5, -3)", for messages: so many significant digits, and at least three after the point.
std::string point_text(const Eigen::Ref<const Eigen::VectorXd>& x, int digits = 6);

/// To so many significant digits, for messages.
std::string short_number(double x, int digits = 3);

/// Two numbers that a message compares: at least so many significant digits, and as many as tell them apart and say by
/// how much.
struct TwoNumbers {
  std::string first, second;
};
TwoNumbers told_apart(double first, double second, int digits = 3);

}  // namespace leastcost
