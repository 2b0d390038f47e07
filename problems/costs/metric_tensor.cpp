// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/metric_tensor.hpp>

#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include "framework/base/dense_solves.hpp"

namespace leastcost {
namespace {

template <int D>
using Matrix =
    Eigen::Matrix<double, D, D, 0, D == Eigen::Dynamic ? kMaxDimension : D, D == Eigen::Dynamic ? kMaxDimension : D>;

template <int D>
struct MetricTensor {
  static constexpr int dim = D;
  Matrix<D> m;  ///< the metric tensor
  Matrix<D> a;  ///< m = a'a, upper triangular

  CostTraits traits() const { return {.unit = "length", .symmetric = true, .additive = true, .below_curves = true}; }

  template <class S>
  Point<S, D> residual(const Point<S, D>& from, const Point<S, D>& to) const {
    return a.template cast<S>() * (to - from);
  }
  template <class S>
  S value(const Point<S, D>& from, const Point<S, D>& to) const {
    return residual<S>(from, to).squaredNorm();
  }
  double gradient(const Point<double, D>& from, const Point<double, D>& to, Point<double, D>& ga,
                  Point<double, D>& gb) const {
    gb.noalias() = 2 * m * (to - from);
    ga = -gb;
    return value<double>(from, to);
  }
  void hessian(const Point<double, D>& from, const Point<double, D>&, Eigen::Ref<Points> h) const {
    const Index d = from.size();
    h.topLeftCorner(d, d) = h.bottomRightCorner(d, d) = 2 * m;
    h.topRightCorner(d, d) = h.bottomLeftCorner(d, d) = -2 * m;
  }
  double line_element(const Eigen::VectorXd&, const Eigen::VectorXd& v) const { return (a * v).norm(); }
};

template <int D>
class MetricTensorCost final : public SegmentCostOf<MetricTensor<D>, ConstantMetricCost> {
  using Base = SegmentCostOf<MetricTensor<D>, ConstantMetricCost>;

 public:
  explicit MetricTensorCost(const Eigen::MatrixXd& m)
      : Base({m, cholesky_factor(m).value()}, static_cast<int>(m.rows())) {}
  Eigen::MatrixXd metric() const override { return this->function().m; }
};

void check_matrix(const Eigen::MatrixXd& m, int dim) {
  const std::string size = std::to_string(m.rows()) + " x " + std::to_string(m.cols());
  if (m.size() == 0) throw OptionError("matrix", "a metric tensor needs a matrix of " + std::to_string(dim) + " rows");
  if (m.rows() != dim || m.cols() != dim)
    throw OptionError("matrix",
                      "the matrix is " + size + ", but the ambient space has dimension " + std::to_string(dim));
  if (!m.allFinite()) throw OptionError("matrix", "entries must be finite");
  if ((m - m.transpose()).cwiseAbs().maxCoeff() > 1e-12 * m.cwiseAbs().maxCoeff())
    throw OptionError("matrix", "a metric tensor must be symmetric, but this matrix is not");
  if (!cholesky_factor(m))
    throw OptionError("matrix", "a metric tensor must be positive definite, but this matrix is not");
}

}  // namespace

void MetricTensorOptions::fields(FieldVisitor& visit) {
  visit.field(
      "matrix", matrix,
      {.help = "Symmetric positive definite matrix M, one row per ambient coordinate; c = sqrt((b-a)' M (b-a)).",
       .required = true});
}

std::shared_ptr<const ConstantMetricCost> make_metric_tensor_cost(const MetricTensorOptions& options, int dim) {
  check_matrix(options.matrix, dim);
  const Eigen::MatrixXd m = (options.matrix + options.matrix.transpose()) / 2;
  if (dim == 2) return std::make_shared<MetricTensorCost<2>>(m);
  if (dim == 3) return std::make_shared<MetricTensorCost<3>>(m);
  return std::make_shared<MetricTensorCost<Eigen::Dynamic>>(m);
}

}  // namespace leastcost
