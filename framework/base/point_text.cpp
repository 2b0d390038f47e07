// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/base/point_text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace leastcost {

std::string point_text(const Eigen::Ref<const Eigen::VectorXd>& x, int digits) {
  std::ostringstream out;
  constexpr int kAfterPoint = 3;  // at least: coordinates of maps have seven digits before it
  constexpr int kMost = 15;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double size = std::abs(x[i]);
    const int before = std::isfinite(size) && size >= 1 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 0;
    out.precision(before + kAfterPoint <= kMost ? std::max(digits, before + kAfterPoint) : digits);
    out << (i == 0 ? "(" : ", ") << x[i];
  }
  out << ')';
  return out.str();
}

std::string short_number(double x, int digits) {
  std::ostringstream out;
  out.precision(digits);
  out << x;
  return out.str();
}

TwoNumbers told_apart(double first, double second, int digits) {
  constexpr int kMost = 15;
  const double size = std::max(std::abs(first), std::abs(second)), apart = std::abs(first - second);
  // Two more than the first digit that differs: they say by how much.
  if (apart > 0 && std::isfinite(size))
    digits = std::clamp(static_cast<int>(std::ceil(std::log10(size / apart))) + 2, digits, std::max(digits, kMost));
  return {short_number(first, digits), short_number(second, digits)};
}

}  // namespace leastcost
