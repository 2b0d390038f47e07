// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/path/kernel.hpp>

namespace leastcost {
namespace {

Jet2 jet_at(const Kernel& kernel, double s) {
  const double q = s * s;
  Jet2 jet;
  kernel.apply({&q, 1}, {&jet, 1});
  return jet;
}

}  // namespace

double kernel_value(const Kernel& kernel, double s) { return jet_at(kernel, s).value; }

double kernel_stiffness(const Kernel& kernel, double s) {
  const Jet2 jet = jet_at(kernel, s);
  return 1 + 2 * s * s * jet.d2 / jet.d1;
}

double kernel_slope_times_s(const Kernel& kernel, double s) { return 2 * jet_at(kernel, s).d1 * s * s; }

double kernel_inverse(const Kernel& kernel, double value) {
  double low = 0, high = 1;
  while (kernel_value(kernel, high) < value) high *= 2;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (kernel_value(kernel, middle) < value ? low : high) = middle;
  }
}

}  // namespace leastcost
