// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/euclidean.hpp>

#include <leastcost/framework/cost/segment_cost_function.hpp>

namespace leastcost {
namespace {

template <int D>
struct Euclidean {
  static constexpr int dim = D;
  CostTraits traits() const { return {.unit = "length", .symmetric = true, .additive = true, .below_curves = true}; }

  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    return (b - a).squaredNorm();
  }
  template <class S>
  Point<S, D> residual(const Point<S, D>& a, const Point<S, D>& b) const {
    return b - a;
  }
  double gradient(const Point<double, D>& a, const Point<double, D>& b, Point<double, D>& ga,
                  Point<double, D>& gb) const {
    gb = 2 * (b - a);
    ga = -gb;
    return (b - a).squaredNorm();
  }
  void hessian(const Point<double, D>& a, const Point<double, D>&, Eigen::Ref<Points> h) const {
    const Index d = D == Eigen::Dynamic ? a.size() : D;
    for (Index k = 0; k < d; ++k) {
      h(k, k) = h(d + k, d + k) = 2;
      h(k, d + k) = h(d + k, k) = -2;
    }
  }
  double line_element(const Eigen::VectorXd&, const Eigen::VectorXd& v) const { return v.norm(); }
};

template <int D>
class EuclideanCost final : public SegmentCostOf<Euclidean<D>, ConstantMetricCost> {
 public:
  explicit EuclideanCost(int dim) : SegmentCostOf<Euclidean<D>, ConstantMetricCost>({}, dim) {}
  Eigen::MatrixXd metric() const override { return Eigen::MatrixXd::Identity(this->dim(), this->dim()); }
};

}  // namespace

std::shared_ptr<const ConstantMetricCost> make_euclidean_cost(int dim) {
  if (dim == 2) return std::make_shared<EuclideanCost<2>>(dim);
  if (dim == 3) return std::make_shared<EuclideanCost<3>>(dim);
  return std::make_shared<EuclideanCost<Eigen::Dynamic>>(dim);
}

}  // namespace leastcost
