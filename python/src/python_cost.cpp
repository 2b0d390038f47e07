// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/python_cost.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leastcost::python {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStep = 1e-150;      // of a complex step: nothing is subtracted, so that it can be as small as this
constexpr double kDifference = 1e-5;  // of second derivatives, in lengths of a path

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

PythonCost::PythonCost(pybind11::function q, int dim, CostTraits traits)
    : q_(std::move(q)), dim_(dim), traits_(std::move(traits)) {}

PythonCost::~PythonCost() {
  const pybind11::gil_scoped_acquire gil;
  q_ = {};
  first_ = nullptr;
}

void PythonCost::raise() const {
  if (first_) std::rethrow_exception(std::exchange(first_, nullptr));
}

template <class Scalar>
PythonCost::Values<Scalar> PythonCost::call(const Rows<Scalar>& a, const Rows<Scalar>& b) const {
  const pybind11::gil_scoped_acquire gil;
  using Array = pybind11::array_t<Scalar, pybind11::array::c_style | pybind11::array::forcecast>;
  try {
    const Array values = q_(Array({a.rows(), a.cols()}, a.data()), Array({b.rows(), b.cols()}, b.data()));
    return Eigen::Map<const Values<Scalar>>(values.data(), values.size());
  } catch (...) {
    if (!failed_.exchange(true)) first_ = std::current_exception();
    throw;
  }
}

Eigen::ArrayXd PythonCost::squares(const Points& a, const Points& b) const {
  const Eigen::ArrayXd q = call<double>(a.array(), b.array());
  return (q >= 0).select(q, kInfinity);
}

Points PythonCost::gradients(const Points& a, const Points& b) const {
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

Points PythonCost::gradients(const AmbientPath& path) const {
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
  // q(x, x + e v) = e^2 v' G v + O(e^3). Its derivative by e, by complex steps at +-e, gives v' G v + O(e^2), and with
  // that at +-e / 2 O(e^4).
  constexpr double e = 1e-3;
  const Eigen::Array4d at(e, -e, e / 2, -e / 2);
  const Rows<Complex> from = x.array().cast<Complex>().replicate(1, 4);
  Rows<Complex> to = from;
  for (Index i = 0; i < 4; ++i) to.col(i) += Complex(at[i], kStep) * v.cast<Complex>().array();
  const Eigen::ArrayXd slope = call<Complex>(from, to).imag() / kStep;
  const double coarse = (slope[0] - slope[1]) / (4 * e), fine = (slope[2] - slope[3]) / (2 * e);
  return std::sqrt((4 * fine - coarse) / 3);
}

}  // namespace leastcost::python
