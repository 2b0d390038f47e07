// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <atomic>
#include <complex>
#include <memory>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/cost/starts_straight.hpp>
#include "python/src/call_errors.hpp"

namespace leastcost::python {

/// How first derivatives of a cost are made. Second derivatives are differences of these.
enum class Derivatives {
  complex_steps,  ///< exact but for rounding, of functions that are analytic
  differences     ///< of order 4, about eleven digits
};

/// What _cost.py makes of a cost written in Python.
struct PythonCostOptions {
  pybind11::function q;      ///< q(a, b), squared costs of shape (n,) of moves between points of shape (d, n)
  pybind11::function check;  ///< check(points), of the first path, shape (d, m): raises where a promise is not kept
  CostTraits traits;
  Derivatives derivatives = Derivatives::complex_steps;
};

/// A cost written in Python. A search on all sides of a straight line would call it for every move alone: it starts
/// straight where there are no obstacles.
class PythonCost final : public SegmentCost, public StartsStraight {
 public:
  PythonCost(PythonCostOptions options, int dim, std::shared_ptr<CallErrors> errors);
  ~PythonCost() override;
  PythonCost(const PythonCost&) = delete;
  PythonCost& operator=(const PythonCost&) = delete;

  /// For Python's garbage collector: visits the functions, as tp_traverse does. With the GIL.
  int traverse(visitproc visit, void* arg) const;
  /// Lets go of them, as tp_clear does; who calls one then gets a TypeError. With the GIL.
  void clear() const;

  int dim() const override { return dim_; }
  const CostTraits& traits() const override { return traits_; }
  void squared_costs(const AmbientPath& path, std::span<double> q) const override;
  double energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                             Eigen::Ref<Points> gradient) const override;
  void chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                    ChainBlocks& out) const override;
  void residuals(const AmbientPath& path, Points& r, Points* jacobians) const override;
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const override;

 private:
  using Complex = std::complex<double>;
  template <class Scalar>
  using Rows = Eigen::Array<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  template <class Scalar>
  using Values = Eigen::Array<Scalar, Eigen::Dynamic, 1>;

  /// What `call` returns, with the GIL; what it raises is kept.
  template <class Call>
  auto guarded(const Call& call) const;
  /// q of the columns of a and b.
  template <class Scalar>
  Values<Scalar> call(const Rows<Scalar>& a, const Rows<Scalar>& b) const;
  /// Lets _cost.py look at the first path of more than one move.
  void check_once(const AmbientPath& path) const;
  /// Infinite where q is not a number >= 0.
  Eigen::ArrayXd squares(const Points& a, const Points& b) const;
  /// Derivatives over (a, b), 2d x n.
  Points gradients(const Points& a, const Points& b) const;
  Points complex_steps(const Points& a, const Points& b) const;
  Points differences(const Points& a, const Points& b) const;
  /// The same of a path, whose ends are constants.
  Points gradients(const AmbientPath& path) const;
  /// Second derivatives, 2d x 2d blocks side by side.
  Points hessians(const Points& a, const Points& b) const;

  mutable pybind11::function q_, check_;  // mutable: a result that is garbage lets go of them
  int dim_;
  CostTraits traits_;
  Derivatives derivatives_;
  std::shared_ptr<CallErrors> errors_;
  mutable std::atomic<bool> checked_ = false;
};

}  // namespace leastcost::python
