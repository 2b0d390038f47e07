// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <span>

namespace leastcost {

/// Value and first two derivatives of a scalar function.
struct Jet2 {
  double value = 0;  ///< of the function
  double d1 = 0;     ///< first derivative
  double d2 = 0;     ///< second derivative
};

/// Behaviour of H at 0, VFCS 4.2.2 (1), (2), (3). Only the third kind supports the doubling test of Eq. (8).
enum class KernelKind { nonzero_at_zero, linear_at_zero, quadratic_at_zero };

/// A kernel author writes phi(q) = H(sqrt(q)) with its derivatives in q = s^2 >= 0, H as in VFCS Eq. (3):
///
///     struct Square {
///       static constexpr KernelKind kind = KernelKind::quadratic_at_zero;
///       Jet2 operator()(double q) const { return {q, 1, 0}; }
///     };
template <class K>
concept KernelFunction = requires(const K k, double q) {
  { k(q) } -> std::same_as<Jet2>;
  { K::kind } -> std::convertible_to<KernelKind>;
};

/// The convex kernel H of the energy sum_i H(c_i / s0), seen through phi(q) = H(sqrt(q)). One call per block of
/// segments. Overflow is +infinity, never an exception: a line search rejects such a trial point.
class Kernel {
 public:
  virtual ~Kernel() = default;
  /// phi(q[i]) into jets[i]; both spans have the same length.
  virtual void apply(std::span<const double> q, std::span<Jet2> jets) const = 0;
  virtual KernelKind kind() const = 0;  ///< how it behaves at 0, which decides what can be extrapolated
  /// Strict convexity: without it (H = s) the points of a minimiser may slide along the path and the spacing,
  /// the index and the exact Hessian mean nothing.
  virtual bool strictly_convex() const = 0;
};

/// Lifts a KernelFunction to the run-level interface.
template <KernelFunction K>
class KernelOf final : public Kernel {
 public:
  explicit KernelOf(K function = {}) : function_(function) {}
  void apply(std::span<const double> q, std::span<Jet2> jets) const override {
    for (std::size_t i = 0; i < q.size(); ++i) jets[i] = function_(q[i]);
  }
  KernelKind kind() const override { return K::kind; }
  bool strictly_convex() const override {
    if constexpr (requires { K::strictly_convex; }) return K::strictly_convex;
    return true;
  }

 private:
  K function_;
};

/// Makes a kernel of a function of the squared cost.
template <KernelFunction K>
std::shared_ptr<const Kernel> make_kernel(K function = {}) {
  return std::make_shared<KernelOf<K>>(function);
}

/// H(s) and H'(s) s for s >= 0; the latter is the natural unit of an energy (a relative change of the cost by e
/// changes the energy by e times the sum of H'(s) s).
double kernel_value(const Kernel& kernel, double s);
double kernel_slope_times_s(const Kernel& kernel, double s);  ///< s H'(s).

/// s H''(s) / H'(s) for s > 0: how stiffly equal spacing is held (0 for H = s, 1 for s^2, 3 for exp(s^2) - 1 at s = 1).
double kernel_stiffness(const Kernel& kernel, double s);

/// The s >= 0 with H(s) = value, by bisection to rounding. Requires H(0) <= value < infinity.
double kernel_inverse(const Kernel& kernel, double value);

}  // namespace leastcost
