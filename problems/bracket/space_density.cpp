// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/space_density.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/cost/encloses_metric.hpp>

namespace leastcost {
namespace {

using SpaceJet = IntervalJet<3>;

/// What third derivatives add within half the sides of the cell.
double cubic_rest(const SpaceJet& n, const Eigen::Vector3d& half) {
  Interval sum(0);
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      for (int k = j; k < 3; ++k) {
        const double orders = i == j && j == k ? 1 : i == j || j == k ? 3 : 6;
        sum += Interval(orders) * abs(n.d(i, j, k)) * Interval(half[i]) * Interval(half[j]) * Interval(half[k]);
      }
  const double rest = (sum / Interval(6)).hi;
  return rest >= 0 ? rest : std::numeric_limits<double>::infinity();
}

SpaceDensityEnclosure enclosure_in_space(const SpaceJet& n, const Eigen::Vector3d& half) {
  SpaceDensityEnclosure out;
  out.value = n.value_at_center();
  for (std::size_t k = 0; k < 3; ++k) out.slope[k] = n.d_at_center(static_cast<int>(k));
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [a, b] = kSymmetricEntries[e];
    out.bend[e] = n.d(a, b);
    out.bend_at_center[e] = n.d_at_center(a, b);
  }
  out.cubic = cubic_rest(n, half);
  return out;
}

/// What holds of both.
SpaceDensityEnclosure of_both_in_space(SpaceDensityEnclosure a, const SpaceDensityEnclosure& b) {
  a.value = hull(a.value, b.value);
  for (std::size_t k = 0; k < 3; ++k) a.slope[k] = hull(a.slope[k], b.slope[k]);
  for (std::size_t e = 0; e < 6; ++e) {
    a.bend[e] = hull(a.bend[e], b.bend[e]);
    a.bend_at_center[e] = hull(a.bend_at_center[e], b.bend_at_center[e]);
  }
  a.cubic = std::max(a.cubic, b.cubic);
  return a;
}

bool is_zero(const SpaceJet& x) { return x.is_constant() && x.value().lo == 0 && x.value().hi == 0; }

/// sqrt(G_11) of a metric G by formula: bounds are of the roots of the whole diagonal alike, where the rest is 0.
class SpaceDensityByFormula final : public SpaceDensity {
 public:
  SpaceDensityByFormula(std::shared_ptr<const SegmentCost> cost, const EnclosesMetric& metric)
      : cost_(std::move(cost)), metric_(metric) {}

  double density(const Eigen::Vector3d& x) const override {
    Eigen::VectorXd place = x;
    return cost_->line_element(place, along_x_);
  }

  SpaceDensityEnclosure enclose_density(const Eigen::AlignedBox3d& cell) const override {
    std::array<SpaceJet, 3> x;
    for (int k = 0; k < 3; ++k) x[static_cast<std::size_t>(k)] = SpaceJet::variable({cell.min()[k], cell.max()[k]}, k);
    std::array<SpaceJet, 6> upper;  // row by row
    metric_.enclose_metric(x, upper);
    if (!is_zero(upper[1]) || !is_zero(upper[2]) || !is_zero(upper[4])) return SpaceDensityEnclosure::unknown();
    for (const std::size_t k : {0U, 3U, 5U})
      if (!(upper[k].value().lo > 0)) return SpaceDensityEnclosure::unknown();
    constexpr double kRounded = 1 + 1e-12;
    const Eigen::Vector3d half =
        cell.sizes() * (kRounded / 2) + 1e-15 * (cell.min().cwiseAbs() + cell.max().cwiseAbs());
    const auto root = [&](std::size_t k) { return enclosure_in_space(sqrt(upper[k]), half); };
    return of_both_in_space(root(0), of_both_in_space(root(3), root(5)));
  }

 private:
  std::shared_ptr<const SegmentCost> cost_;
  const EnclosesMetric& metric_;  // a part of the cost
  const Eigen::VectorXd along_x_ = Eigen::Vector3d::UnitX();
};

}  // namespace

SpaceDensityEnclosure SpaceDensityEnclosure::unknown() {
  SpaceDensityEnclosure out;
  out.value = Interval::all();
  out.slope.fill(Interval::all());
  out.bend.fill(Interval::all());
  out.bend_at_center.fill(Interval::all());
  out.cubic = std::numeric_limits<double>::infinity();
  return out;
}

bool SpaceDensityEnclosure::is_finite() const {
  const auto finite = [](const Interval& x) { return x.is_finite(); };
  return finite(value) && std::all_of(slope.begin(), slope.end(), finite) &&
         std::all_of(bend.begin(), bend.end(), finite);
}

std::shared_ptr<const SpaceDensity> space_density_of(const std::shared_ptr<const SegmentCost>& cost) {
  if (cost == nullptr || cost->dim() != 3) return nullptr;
  if (const auto* density = find_ability<SpaceDensity>(*cost)) return {cost, density};
  if (const auto* metric = find_ability<EnclosesMetric>(*cost))
    return std::make_shared<const SpaceDensityByFormula>(cost, *metric);
  return nullptr;
}

double move_cost_above(const SpaceDensity& density, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const SpaceDensityEnclosure n = density.enclose_density({a.cwiseMin(b), a.cwiseMax(b)});
  if (!n.is_finite()) return std::numeric_limits<double>::infinity();
  std::array<Interval, 3> d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = Interval(b[static_cast<int>(k)]) - Interval(a[static_cast<int>(k)]);
  const Interval length = sqrt(square(d[0]) + square(d[1]) + square(d[2]));
  // The centre is the middle of the move but for rounding.
  const Interval off(kRounding * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()));
  const Interval at_middle = n.value + off * (abs(n.slope[0]) + abs(n.slope[1]) + abs(n.slope[2]));
  const Interval straight = n.bend[0] * square(d[0]) + n.bend[1] * square(d[1]) + n.bend[2] * square(d[2]);
  const Interval mixed = n.bend[3] * d[0] * d[1] + n.bend[4] * d[0] * d[2] + n.bend[5] * d[1] * d[2];
  return (length * (at_middle + (straight + Interval(2) * mixed) / Interval(24))).hi;
}

double polyline_cost_above(const SpaceDensity& density, const Eigen::Ref<const Eigen::Matrix3Xd>& x) {
  Interval sum(0);
  for (Eigen::Index i = 0; i + 1 < x.cols(); ++i) sum += Interval(move_cost_above(density, x.col(i), x.col(i + 1)));
  return sum.hi;
}

}  // namespace leastcost
