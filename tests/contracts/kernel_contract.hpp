// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <leastcost/framework/path/kernel.hpp>
#include "framework/check/observed_order.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {

inline Jet2 jet_of(const Kernel& kernel, double q) {
  Jet2 jet;
  kernel.apply({&q, 1}, {&jet, 1});
  return jet;
}

/// phi' and phi'' are the derivatives of phi at q. Steps are relative to q: a kernel need not be smooth at 0.
inline void check_kernel_derivatives(const Kernel& kernel, double q) {
  CAPTURE(q);
  const Jet2 jet = jet_of(kernel, q);
  const double floor = 20 * std::numeric_limits<double>::epsilon() * (std::abs(jet.value) + std::abs(jet.d1) * q);
  const auto difference = [&](double h) { return jet_of(kernel, q + h).value - jet.value; };
  CHECK(observed_order([&](double h) { return difference(h) - jet.d1 * h; }, q / 4, floor) > 2 - kOrderSlack);
  CHECK(observed_order([&](double h) { return difference(h) - jet.d1 * h - jet.d2 * h * h / 2; }, q / 4, floor) >
        3 - kOrderSlack);
}

/// H increases and is convex: H' = 2 s phi' > 0, H'' = 2 phi' + 4 q phi'' >= 0 (to the rounding of their cancellation).
inline void check_kernel_convexity(const Kernel& kernel, double q) {
  CAPTURE(q);
  const Jet2 jet = jet_of(kernel, q);
  const double first = 2 * jet.d1, second = 4 * q * jet.d2;
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * (std::abs(first) + std::abs(second));
  CHECK(jet.d1 > 0);
  CHECK(first + second >= -rounding);
  if (kernel.strictly_convex() && q > 1e-6) CHECK(first + second > rounding);
}

/// The kind it claims is its behaviour at 0, VFCS 4.2.2 (1), (2), (3); and so is the limit of Eq. (8).
inline void check_kernel_kind(const Kernel& kernel) {
  const double s = 1e-3;
  const double at0 = kernel_value(kernel, 0), h = kernel_value(kernel, s), half = kernel_value(kernel, s / 2);
  const double doubling = h / (2 * half);
  switch (kernel.kind()) {
    case KernelKind::nonzero_at_zero:
      CHECK(at0 != 0);
      CHECK(doubling == Approx(0.5).epsilon(s));
      break;
    case KernelKind::linear_at_zero:
      CHECK(at0 == 0);
      CHECK(doubling == Approx(1).epsilon(s));
      break;
    case KernelKind::quadratic_at_zero:
      CHECK(at0 == 0);
      CHECK(doubling == Approx(2).epsilon(s));
      break;
  }
}

/// H^-1 inverts H, as well as the condition of H allows.
inline void check_kernel_inverse(const Kernel& kernel, double s) {
  CAPTURE(s);
  const double value = kernel_value(kernel, s), slope = kernel_slope_times_s(kernel, s) / s;
  const double eps = std::numeric_limits<double>::epsilon();
  CHECK(std::abs(kernel_inverse(kernel, value) - s) <= 8 * eps * (s + value / slope));
}

/// Overflow is +infinity, never NaN, and derivatives are finite where the value is.
inline void check_kernel_overflow(const Kernel& kernel) {
  for (const double q : {0.0, 1e-300, 1e-30, 500.0, 700.0, 709.0, 1e3, 4e5, 5e5, 1e6, 1e30, 1e300,
                         std::numeric_limits<double>::infinity()}) {
    CAPTURE(q);
    const Jet2 jet = jet_of(kernel, q);
    CHECK(jet.value >= 0);
    if (std::isfinite(jet.value)) CHECK(std::isfinite(jet.d1 + jet.d2));
  }
}

/// A block of q gives what each q gives.
inline void check_kernel_blocks(const Kernel& kernel, Random& random) {
  std::array<double, 67> q{};
  std::array<Jet2, 67> jets{};
  for (double& x : q) x = random.uniform(0, 3);
  kernel.apply(q, jets);
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Jet2 jet = jet_of(kernel, q[i]);
    CHECK((jets[i].value == jet.value && jets[i].d1 == jet.d1 && jets[i].d2 == jet.d2));
  }
}

/// The contract of Kernel (framework/path/kernel.hpp).
inline void check_kernel_contract(const Kernel& kernel) {
  Random random;
  for (const double q : {1e-8, 0.01, 1.0, 4.0, random.uniform(0.1, 9)}) {
    check_kernel_derivatives(kernel, q);
    check_kernel_convexity(kernel, q);
    check_kernel_inverse(kernel, std::sqrt(q));
  }
  check_kernel_kind(kernel);
  check_kernel_overflow(kernel);
  check_kernel_blocks(kernel, random);
}

}  // namespace leastcost::test
