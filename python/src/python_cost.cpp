// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/python_cost.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::python {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStep = 1e-150;      // of a complex step: nothing is subtracted, so that it can be as small as this
constexpr double kDifference = 1e-5;  // of second derivatives, in lengths of a path
constexpr double kPartOfMove = 1e-3;  // steps of differences

Points begins(const AmbientPath& path) { return path.x.leftCols(path.segment_count()); }
Points ends(const AmbientPath& path) { return path.x.rightCols(path.segment_count()); }

double size_of(const Points& a, const Points& b) {
  const double size = (a.rowwise().maxCoeff().cwiseMax(b.rowwise().maxCoeff()) -
                       a.rowwise().minCoeff().cwiseMin(b.rowwise().minCoeff()))
                          .norm();
  return std::max(size, 1e-300);
}

Eigen::MatrixXd positive_part(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

Jet2 apply(const Kernel& kernel, double s) {
  Jet2 phi;
  kernel.apply({&s, 1}, {&phi, 1});
  return phi;
}

}  // namespace

PythonCost::PythonCost(PythonCostOptions options, int dim, std::shared_ptr<CallErrors> errors)
    : q_(std::move(options.q)),
      check_(std::move(options.check)),
      dim_(dim),
      traits_(std::move(options.traits)),
      derivatives_(options.derivatives),
      errors_(std::move(errors)) {}

PythonCost::~PythonCost() {
  const pybind11::gil_scoped_acquire gil;
  q_ = {};
  check_ = {};
}

int PythonCost::traverse(visitproc visit, void* arg) const {
  Py_VISIT(q_.ptr());
  Py_VISIT(check_.ptr());
  return 0;
}

void PythonCost::clear() const {
  const pybind11::object q = std::exchange(q_, pybind11::reinterpret_borrow<pybind11::function>(pybind11::none()));
  const pybind11::object check =
      std::exchange(check_, pybind11::reinterpret_borrow<pybind11::function>(pybind11::none()));
}

template <class Call>
auto PythonCost::guarded(const Call& call) const {
  if (errors_->any()) throw Interrupted("a function has raised an exception");
  const pybind11::gil_scoped_acquire gil;
  try {
    return call();
  } catch (...) {
    errors_->keep(std::current_exception());
    throw;
  }
}

template <class Scalar>
PythonCost::Values<Scalar> PythonCost::call(const Rows<Scalar>& a, const Rows<Scalar>& b) const {
  using Array = pybind11::array_t<Scalar, pybind11::array::c_style | pybind11::array::forcecast>;
  return guarded([&]() -> Values<Scalar> {
    const Array values = q_(Array({a.rows(), a.cols()}, a.data()), Array({b.rows(), b.cols()}, b.data()));
    return Eigen::Map<const Values<Scalar>>(values.data(), values.size());
  });
}

void PythonCost::check_once(const AmbientPath& path) const {
  if (path.segment_count() < 2 || checked_.exchange(true)) return;
  const Rows<double> points = path.x.array();
  guarded([&] { check_(pybind11::array_t<double>({points.rows(), points.cols()}, points.data())); });
}

Eigen::ArrayXd PythonCost::squares(const Points& a, const Points& b) const {
  const Eigen::ArrayXd q = call<double>(a.array(), b.array());
  return (q >= 0).select(q, kInfinity);
}

Points PythonCost::gradients(const Points& a, const Points& b) const {
  return derivatives_ == Derivatives::complex_steps ? complex_steps(a, b) : differences(a, b);
}

Points PythonCost::complex_steps(const Points& a, const Points& b) const {
  const Index n = a.cols(), d = dim_;
  // One call: block k of n columns has the step on variable k of (a, b).
  Rows<Complex> from = a.array().cast<Complex>().replicate(1, 2 * d);
  Rows<Complex> to = b.array().cast<Complex>().replicate(1, 2 * d);
  for (Index k = 0; k < d; ++k) {
    from.block(k, k * n, 1, n) += Complex(0, kStep);
    to.block(k, (d + k) * n, 1, n) += Complex(0, kStep);
  }
  const Values<Complex> q = call<Complex>(from, to);
  return Eigen::Map<const Rows<Complex>>(q.data(), 2 * d, n).imag().matrix() / kStep;
}

Points PythonCost::differences(const Points& a, const Points& b) const {
  const Index n = a.cols(), d = dim_, w = 2 * d;
  // A part of the length of each move; a power of 2, so that most steps are what they are meant to be.
  const double least = kDifference * size_of(a, b);
  const Eigen::ArrayXd step = (b - a).colwise().norm().transpose().unaryExpr(
      [&](double length) { return std::exp2(std::floor(std::log2(kPartOfMove * (length > 0 ? length : least)))); });
  constexpr std::array<double, 4> kSteps = {-2, -1, 1, 2};
  Rows<double> from = a.array().replicate(1, 4 * w), to = b.array().replicate(1, 4 * w);  // one call
  for (Index k = 0; k < w; ++k)
    for (Index s = 0; s < 4; ++s)
      (k < d ? from : to).block(k % d, (4 * k + s) * n, 1, n) += kSteps[static_cast<std::size_t>(s)] * step.transpose();
  const Values<double> q = call<double>(from, to);
  Points slopes(w, n);
  for (Index k = 0; k < w; ++k) {
    const auto at = [&](Index s) { return q.segment((4 * k + s) * n, n); };
    slopes.row(k) = ((8 * (at(2) - at(1)) - (at(3) - at(0))) / (12 * step)).matrix().transpose();
  }
  return slopes;
}

Points PythonCost::gradients(const AmbientPath& path) const {
  check_once(path);
  Points gradient = gradients(begins(path), ends(path));
  if (path.begin_fixed()) gradient.col(0).head(dim_).setZero();
  if (path.end_fixed()) gradient.rightCols(1).bottomRows(dim_).setZero();
  return gradient;
}

Points PythonCost::hessians(const Points& a, const Points& b) const {
  const Index n = a.cols(), d = dim_, w = 2 * d;
  const double step = kDifference * size_of(a, b);
  Points blocks(w, w * n);
  for (Index k = 0; k < w; ++k) {
    look_at_clock(errors_->deadline());  // in many dimensions a few moves take seconds
    const auto moved = [&](double by) {
      Points from = a, to = b;
      (k < d ? from.row(k) : to.row(k - d)).array() += by;
      return gradients(from, to);
    };
    const Points columns = (moved(step) - moved(-step)) / (2 * step);
    for (Index i = 0; i < n; ++i) blocks.col(w * i + k) = columns.col(i);
  }
  return blocks;
}

void PythonCost::squared_costs(const AmbientPath& path, std::span<double> q) const {
  check_once(path);
  const Eigen::ArrayXd values = squares(begins(path), ends(path));
  std::copy(values.begin(), values.end(), q.begin());
}

double PythonCost::energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                                       Eigen::Ref<Points> gradient) const {
  const Eigen::ArrayXd q = squares(begins(path), ends(path));
  const Points slopes = gradients(path);
  const double scale = 1 / (s0 * s0);
  double energy = 0;
  gradient.setZero();
  for (Index i = 0; i < q.size(); ++i) {
    const Jet2 phi = apply(kernel, scale * q[i]);
    energy += phi.value;
    gradient.col(i) += scale * phi.d1 * slopes.col(i).head(dim_);
    gradient.col(i + 1) += scale * phi.d1 * slopes.col(i).tail(dim_);
  }
  return std::isnan(energy) ? kInfinity : energy;
}

void PythonCost::chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                              ChainBlocks& out) const {
  check_once(path);
  const Points a = begins(path), b = ends(path);
  const Eigen::ArrayXd q = squares(a, b);
  const Points slopes = gradients(a, b);
  out.blocks = hessians(a, b);
  const Index n = q.size(), w = 2 * dim_;
  const double scale = 1 / (s0 * s0);
  for (Index i = 0; i < n; ++i) {
    const Jet2 phi = apply(kernel, scale * q[i]);
    auto at = out.blocks.middleCols(w * i, w);
    const Eigen::MatrixXd curvature = 0.5 * scale * phi.d1 * (at + at.transpose());
    Eigen::MatrixXd block = curvature + scale * scale * phi.d2 * slopes.col(i) * slopes.col(i).transpose();
    const auto fix = [&](Index first) {
      block.middleRows(first, dim_).setZero();
      block.middleCols(first, dim_).setZero();
    };
    if (path.begin_fixed() && i == 0) fix(0);
    if (path.end_fixed() && i + 1 == n) fix(dim_);
    at = kind == HessianKind::gauss_newton ? positive_part(block) : block;
  }
}

void PythonCost::residuals(const AmbientPath& path, Points& r, Points* jacobians) const {
  r = squares(begins(path), ends(path)).sqrt().matrix().transpose();
  if (jacobians == nullptr) return;
  const Points slopes = gradients(path);
  const Index w = 2 * dim_;
  jacobians->resize(1, w * r.cols());
  for (Index i = 0; i < r.cols(); ++i) jacobians->middleCols(w * i, w) = slopes.col(i).transpose() / (2 * r(0, i));
}

double PythonCost::line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
  // q(x, x + e v) / e^2 tends to the square of what is asked for, also of a cost that is not the same backwards.
  constexpr int kMoves = 4;
  constexpr double kLongest = 4e-3;
  const Eigen::Array4d e = kLongest / Eigen::Array4d(1, 2, 4, 8);
  const auto limit = [&](const Points& a, const Points& b) {
    Eigen::Array4d f = squares(a, b) / (e * e);
    for (int level = 1; level < kMoves; ++level)  // Richardson: the error is of order 4
      for (int i = 0; i + level < kMoves; ++i) f[i] = (std::exp2(level) * f[i + 1] - f[i]) / (std::exp2(level) - 1);
    return f[0] >= 0 ? std::sqrt(f[0]) : kInfinity;
  };
  const Points here = x.replicate(1, kMoves), steps = v * e.matrix().transpose();
  const double leaving = limit(here, here + steps);
  return std::isfinite(leaving) ? leaving : limit(here - steps, here);  // at a border of where q is defined
}

}  // namespace leastcost::python
