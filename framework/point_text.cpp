// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/point_text.hpp"

#include <sstream>

namespace leastcost {

std::string point_text(const Eigen::Ref<const Eigen::VectorXd>& x, int digits) {
  std::ostringstream out;
  out.precision(digits);
  for (Eigen::Index i = 0; i < x.size(); ++i) out << (i == 0 ? "(" : ", ") << x[i];
  out << ')';
  return out.str();
}

std::string short_number(double x, int digits) {
  std::ostringstream out;
  out.precision(digits);
  out << x;
  return out.str();
}

}  // namespace leastcost
