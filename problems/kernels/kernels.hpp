// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <leastcost/framework/path/kernel.hpp>

namespace leastcost {

/// H(s) = s^2. VFCS 4.2.2 (3).
struct Square {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;  ///< how it behaves at 0
  Jet2 operator()(double q) const { return {q, 1, 0}; }
};

/// H(s) = exp(s^2) - 1, the choice of VFCS.
struct Expm1Square {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;  ///< how it behaves at 0
  Jet2 operator()(double q) const {
    const double e = std::exp(q);
    return {std::expm1(q), e, e};
  }
};

/// H(s) = exp(s^2). VFCS 4.2.2 (1).
struct ExpSquare {
  static constexpr KernelKind kind = KernelKind::nonzero_at_zero;  ///< how it behaves at 0
  Jet2 operator()(double q) const {
    const double e = std::exp(q);
    return {e, e, e};
  }
};

/// phi(q) = f(sqrt q) from f, f', f'' at s = sqrt(q): phi' = f' / (2 s), phi'' = (f'' - f' / s) / (4 s^2). These
/// kernels are not differentiable in q at 0; s is kept above a guard, below which phi' would overflow the chain
/// Hessian.
inline Jet2 of_root(double s, double f, double f1, double f2) { return {f, f1 / (2 * s), (f2 - f1 / s) / (4 * s * s)}; }
/// The cost of a squared cost, kept away from 0, where its derivative is infinite.
inline double guarded_root(double q) { return std::sqrt(std::max(q, 1e-24)); }

/// H(s) = s. Not strictly convex: points may slide along the path and collapse onto each other.
struct Linear {
  static constexpr KernelKind kind = KernelKind::linear_at_zero;  ///< how it behaves at 0
  static constexpr bool strictly_convex = false;                  ///< points may slide along the path
  Jet2 operator()(double q) const { return of_root(guarded_root(q), std::sqrt(q), 1, 0); }
};

/// H(s) = exp(s). VFCS 4.2.2 (1).
struct Exp {
  static constexpr KernelKind kind = KernelKind::nonzero_at_zero;  ///< how it behaves at 0
  Jet2 operator()(double q) const {
    const double e = std::exp(std::sqrt(q));
    return of_root(guarded_root(q), e, e, e);
  }
};

/// H(s) = exp(s) - 1. VFCS 4.2.2 (2).
struct Expm1 {
  static constexpr KernelKind kind = KernelKind::linear_at_zero;  ///< how it behaves at 0
  Jet2 operator()(double q) const {
    const double s = std::sqrt(q), e = std::exp(s);
    return of_root(guarded_root(q), std::expm1(s), e, e);
  }
};

}  // namespace leastcost
