// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <atomic>
#include <complex>
#include <exception>

#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost::python {

/// A cost written in Python: q(a, b), squared costs of shape (n,) of moves between points of shape (d, n), which must
/// be analytic. First derivatives are complex steps, exact but for rounding; second derivatives are differences of
/// these. _find_path.py checks shapes and that q is analytic.
class PythonCost final : public SegmentCost {
 public:
  PythonCost(pybind11::function q, int dim, CostTraits traits);
  ~PythonCost() override;
  PythonCost(const PythonCost&) = delete;
  PythonCost& operator=(const PythonCost&) = delete;

  int dim() const override { return dim_; }
  const CostTraits& traits() const override { return traits_; }
  void squared_costs(const AmbientPath& path, std::span<double> q) const override;
  double energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                             Eigen::Ref<Points> gradient) const override;
  void chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                    ChainBlocks& out) const override;
  void residuals(const AmbientPath& path, Points& r, Points* jacobians) const override;
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const override;

  /// Whether q has raised an exception: the search cannot go on. With or without the GIL.
  bool failed() const { return failed_; }
  /// Raises the first exception of q, with its traceback. With the GIL.
  void raise() const;

 private:
  using Complex = std::complex<double>;
  template <class Scalar>
  using Rows = Eigen::Array<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  template <class Scalar>
  using Values = Eigen::Array<Scalar, Eigen::Dynamic, 1>;

  /// q of the columns of a and b.
  template <class Scalar>
  Values<Scalar> call(const Rows<Scalar>& a, const Rows<Scalar>& b) const;
  /// Infinite where q is not a number >= 0.
  Eigen::ArrayXd squares(const Points& a, const Points& b) const;
  /// Derivatives over (a, b), 2d x n.
  Points gradients(const Points& a, const Points& b) const;
  /// The same of a path, whose ends are constants.
  Points gradients(const AmbientPath& path) const;
  /// Second derivatives, 2d x 2d blocks side by side.
  Points hessians(const Points& a, const Points& b) const;

  pybind11::function q_;
  int dim_;
  CostTraits traits_;
  mutable std::exception_ptr first_;  // guarded by the GIL
  mutable std::atomic<bool> failed_ = false;
};

}  // namespace leastcost::python
