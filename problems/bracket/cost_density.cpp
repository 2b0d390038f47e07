// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/cost_density.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/cost/encloses_metric.hpp>

namespace leastcost {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Jet = IntervalJet<2>;

DensityEnclosure enclosure_of(const Jet& n) {
  return {n.value_at_center(), n.d_at_center(0), n.d_at_center(1), n.d(0, 0), n.d(0, 1), n.d(1, 1)};
}

/// What holds of both.
DensityEnclosure of_both(const DensityEnclosure& a, const DensityEnclosure& b) {
  return {hull(a.value, b.value), hull(a.dx, b.dx), hull(a.dy, b.dy),
          hull(a.xx, b.xx),       hull(a.xy, b.xy), hull(a.yy, b.yy)};
}

/// sqrt(G_11) of a metric G by formula: bounds are of that and of sqrt(G_22) alike, where G_12 = 0.
class DensityByFormula final : public CostDensity {
 public:
  DensityByFormula(std::shared_ptr<const SegmentCost> cost, const EnclosesMetric& metric)
      : cost_(std::move(cost)), metric_(metric) {}

  double density(const Vector2d& x) const override {
    Eigen::VectorXd place = x;
    return cost_->line_element(place, along_x_);
  }

  DensityEnclosure enclose_density(const AlignedBox2d& cell) const override {
    const std::array<Jet, 2> x = {Jet::variable({cell.min()[0], cell.max()[0]}, 0),
                                  Jet::variable({cell.min()[1], cell.max()[1]}, 1)};
    std::array<Jet, 3> upper;
    metric_.enclose_metric(x, upper);
    const bool across = !upper[1].is_constant() || upper[1].value().lo != 0 || upper[1].value().hi != 0;
    if (across || !(upper[0].value().lo > 0) || !(upper[2].value().lo > 0)) return DensityEnclosure::unknown();
    return of_both(enclosure_of(sqrt(upper[0])), enclosure_of(sqrt(upper[2])));
  }

 private:
  std::shared_ptr<const SegmentCost> cost_;
  const EnclosesMetric& metric_;  // a part of the cost
  const Eigen::VectorXd along_x_ = Eigen::Vector2d::UnitX();
};

}  // namespace

DensityEnclosure DensityEnclosure::unknown() {
  const Interval all = Interval::all();
  return {all, all, all, all, all, all};
}

bool DensityEnclosure::is_finite() const {
  return value.is_finite() && dx.is_finite() && dy.is_finite() && xx.is_finite() && xy.is_finite() && yy.is_finite() &&
         std::isfinite(slack);
}

std::shared_ptr<const CostDensity> density_of(const std::shared_ptr<const SegmentCost>& cost) {
  if (cost == nullptr || cost->dim() != 2) return nullptr;
  if (const auto* density = find_ability<CostDensity>(*cost)) return {cost, density};
  if (const auto* metric = find_ability<EnclosesMetric>(*cost))
    return std::make_shared<const DensityByFormula>(cost, *metric);
  return nullptr;
}

double move_cost_above(const CostDensity& density, const Vector2d& a, const Vector2d& b) {
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const AlignedBox2d box(a.cwiseMin(b), a.cwiseMax(b));
  const DensityEnclosure n = density.enclose_density(box);
  if (!n.is_finite()) return std::numeric_limits<double>::infinity();
  const Interval x = Interval(b[0]) - Interval(a[0]), y = Interval(b[1]) - Interval(a[1]);
  const Interval squared = square(x) + square(y), length = sqrt(squared);
  // The centre is the middle of the move but for rounding.
  const Interval off(kRounding * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()));
  const Interval at_middle = n.value + Interval(n.slack) + off * (abs(n.dx) + abs(n.dy));
  const Interval bent = n.xx * square(x) + Interval(2) * n.xy * x * y + n.yy * square(y);
  return (length * (at_middle + bent / Interval(24))).hi;
}

double polyline_cost_above(const CostDensity& density, const Eigen::Ref<const Eigen::Matrix2Xd>& x) {
  Interval sum(0);
  for (Eigen::Index i = 0; i + 1 < x.cols(); ++i) sum += Interval(move_cost_above(density, x.col(i), x.col(i + 1)));
  return sum.hi;
}

}  // namespace leastcost
