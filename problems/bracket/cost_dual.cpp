// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/cost_dual.hpp>

#include <utility>

#include <leastcost/framework/cost/encloses_metric.hpp>

namespace leastcost {
namespace {

using Eigen::Vector2d;

/// The inverse of a metric by formula.
class DualByFormula final : public CostDual {
 public:
  DualByFormula(std::shared_ptr<const SegmentCost> cost, const EnclosesMetric& metric)
      : cost_(std::move(cost)), metric_(metric) {}

  DualNorm<double> dual(const Vector2d& x) const override {
    const Eigen::VectorXd place = x;
    const auto squared = [&](double a, double b) {
      const double c = cost_->line_element(place, Vector2d(a, b));
      return c * c;
    };
    const double g11 = squared(1, 0), g22 = squared(0, 1), g12 = 0.25 * (squared(1, 1) - squared(1, -1));
    const double det = g11 * g22 - g12 * g12;
    return {g22 / det, -g12 / det, g11 / det, 0, 0};
  }

  DualNorm<Jet> enclose_dual(const std::array<Jet, 2>& x) const override {
    std::array<Jet, 3> g;
    metric_.enclose_metric(x, g);
    const Jet det = g[0] * g[2] - g[1] * g[1];
    if (!(det.value().lo > 0) || !(g[0].value().lo > 0)) {
      const Jet unknown = Jet::unknown();
      return {unknown, unknown, unknown, unknown, unknown};
    }
    const Jet one_over = Jet(1.0) / det;
    return {g[2] * one_over, -g[1] * one_over, g[0] * one_over, Jet(0.0), Jet(0.0)};
  }

 private:
  std::shared_ptr<const SegmentCost> cost_;
  const EnclosesMetric& metric_;  // a part of the cost
};

}  // namespace

std::shared_ptr<const CostDual> dual_of(const std::shared_ptr<const SegmentCost>& cost) {
  if (cost == nullptr || cost->dim() != 2) return nullptr;
  if (const auto* dual = find_ability<CostDual>(*cost)) return {cost, dual};
  if (const auto* metric = find_ability<EnclosesMetric>(*cost))
    return std::make_shared<const DualByFormula>(cost, *metric);
  return nullptr;
}

/// The middle of the move and the second derivative along it bound the integral of F(x(t), b - a), t in [0, 1].
double move_cost_above(const CostDual& dual, const Vector2d& a, const Vector2d& b) {
  using Jet = CostDual::Jet;
  if (a == b) return 0;
  const Interval dx = Interval(b[0]) - Interval(a[0]), dy = Interval(b[1]) - Interval(a[1]);
  const Jet t = Jet::variable({0, 1}, 0);
  const DualNorm<Jet> norm = dual.enclose_dual({Jet(a[0]) + t.scaled(dx), Jet(a[1]) + t.scaled(dy)});
  const Jet f = norm.cost(Jet(dx), Jet(dy));
  const double cost = (f.value_at_center() + f.d(0, 0) / Interval(24)).hi;
  return cost >= 0 ? cost : std::numeric_limits<double>::infinity();  // NaN as well
}

double polyline_cost_above(const CostDual& dual, const Eigen::Ref<const Eigen::Matrix2Xd>& x) {
  Interval sum(0);
  for (Eigen::Index i = 0; i + 1 < x.cols(); ++i) sum += Interval(move_cost_above(dual, x.col(i), x.col(i + 1)));
  return sum.hi;
}

}  // namespace leastcost
