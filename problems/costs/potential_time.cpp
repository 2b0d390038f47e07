// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/potential_time.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/cost/starts_straight.hpp>
#include "problems/formula/coordinate_names.hpp"
#include "problems/formula/formula.hpp"

namespace leastcost {
namespace {

constexpr double kAtRest = 1e-10;  ///< relative error of coordinates and level, below which an end is at rest

/// v^2 = 2 (level - U(x)).
struct PotentialLevel {
  Formula potential;
  double level;

  template <class S>
  S squared_speed(std::span<const S> x) const {
    return S(2.0) * S(S(level) - potential(x));
  }

  /// How far v^2 may be below zero at a place where the bead is at rest: its coordinates are rounded.
  double rounding(std::span<const double> x) const {
    std::vector<Dual<double, 1>> at(x.begin(), x.end());
    double sum = std::abs(level);
    for (std::size_t i = 0; i < x.size(); ++i) {
      at[i].d[0] = 1;
      sum += std::abs(potential(std::span<const Dual<double, 1>>(at)).d[0] * x[i]);
      at[i].d[0] = 0;
    }
    return 2 * kAtRest * sum;
  }
};

/// 2 L / (v_a + v_b): exact where U is linear along the segment. From rest to rest there is no such time.
template <int D>
struct PotentialChute {
  static constexpr int dim = D;
  PotentialLevel energy;

  CostTraits traits() const { return {.unit = "s", .symmetric = true}; }

  /// Negative where the bead cannot be. At rest the value is 0 while the derivatives stay: they are infinite in the
  /// interior of a path, and a fixed end has none.
  template <class S>
  S speed(const Point<S, D>& x) const {
    using std::sqrt;
    S v2 = energy.squared_speed(std::span<const S>(x.data(), static_cast<std::size_t>(x.size())));
    if (!std::isfinite(innermost(v2))) return S(-1.0);
    if (innermost(v2) < 0) {
      Point<double, D> place(x.size());
      for (Index i = 0; i < x.size(); ++i) place[i] = innermost(x[i]);
      if (-innermost(v2) > energy.rounding({place.data(), static_cast<std::size_t>(place.size())})) return S(-1.0);
      v2 -= S(innermost(v2));
    }
    return sqrt(v2);
  }

  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    const S va = speed<S>(a), vb = speed<S>(b), sum = va + vb;
    if (innermost(va) >= 0 && innermost(vb) >= 0 && innermost(sum) > 0)
      return 4.0 * (b - a).squaredNorm() / (sum * sum);
    return S(a == b && innermost(va) >= 0 ? 0.0 : std::numeric_limits<double>::infinity());
  }
  template <class S>
  Point<S, D> residual(const Point<S, D>& a, const Point<S, D>& b) const {
    const S va = speed<S>(a), vb = speed<S>(b), sum = va + vb;
    const bool finite = innermost(va) >= 0 && innermost(vb) >= 0 && innermost(sum) > 0;
    const S factor = finite ? S(S(2.0) / sum) : S(std::numeric_limits<double>::infinity());
    return (b - a) * factor;
  }

  /// q = f(V) L, L = |u|^2, f = 4 / V^2 and V the sum of the speeds: each is differentiated at its own end alone, half
  /// as many directions as both ends have. What is infinite at an end at rest stays in its own rows and columns.
  void hessian(const Point<double, D>& a, const Point<double, D>& b, Eigen::Ref<Points> h) const
      requires(D != Eigen::Dynamic) {
    using Square = Eigen::Matrix<double, D, D>;
    Point<double, D> slope_a, slope_b;
    Square bend_a, bend_b;
    const double sum = speed_jet(a, slope_a, bend_a) + speed_jet(b, slope_b, bend_b);
    const double f = 4 / (sum * sum), f1 = -2 * f / sum, f2 = -3 * f1 / sum;
    const Point<double, D> u = b - a;
    const double length2 = u.squaredNorm();
    const Square twice = 2 * f * Square::Identity(), across_a = 2 * f1 * slope_a * u.transpose(),
                 across_b = 2 * f1 * u * slope_b.transpose();
    h.topLeftCorner(D, D) =
        length2 * (f2 * slope_a * slope_a.transpose() + f1 * bend_a) - across_a - across_a.transpose() + twice;
    h.bottomRightCorner(D, D) =
        length2 * (f2 * slope_b * slope_b.transpose() + f1 * bend_b) + across_b + across_b.transpose() + twice;
    h.topRightCorner(D, D) = length2 * f2 * slope_a * slope_b.transpose() + across_a - across_b - twice;
    h.bottomLeftCorner(D, D) = h.topRightCorner(D, D).transpose();
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    const double own = speed<double>(Point<double, D>(x));
    return own > 0 ? v.norm() / own : std::numeric_limits<double>::infinity();
  }

  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const Eigen::IOFormat row(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
    std::ostringstream out;
    for (const Eigen::VectorXd& x : {a, b}) {
      if (speed<double>(Point<double, D>(x)) >= 0) continue;
      out << "the potential at " << x.format(row) << " is "
          << energy.potential(std::span<const double>(x.data(), static_cast<std::size_t>(x.size())))
          << ", above the energy " << energy.level << " of the bead";
      return out.str();
    }
    if (!(speed<double>(Point<double, D>(a)) + speed<double>(Point<double, D>(b)) > 0))
      out << "the bead is at rest at both " << a.format(row) << " and " << b.format(row) << " and cannot start";
    return out.str();
  }

 private:
  double speed_jet(const Point<double, D>& place, Point<double, D>& slope, Eigen::Matrix<double, D, D>& bend) const {
    using S = Dual<Dual<double, D>, D>;
    Point<S, D> x;
    for (int i = 0; i < D; ++i) {
      const auto k = static_cast<std::size_t>(i);
      x[i] = S(place[i]);
      x[i].value.d[k] = 1;
      x[i].d[k] = Dual<double, D>(1.0);
    }
    const S v = speed<S>(x);
    for (int i = 0; i < D; ++i) {
      slope[i] = v.value.d[static_cast<std::size_t>(i)];
      for (int k = 0; k < D; ++k) bend(i, k) = v.d[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(k)];
    }
    return v.value.value;
  }
};

template <int D>
class PotentialTimeCost final : public SegmentCostOf<PotentialChute<D>>,
                                public ConformalMetricBy<PotentialTimeCost<D>>,
                                public StartsStraight {
 public:
  using SegmentCostOf<PotentialChute<D>>::SegmentCostOf;

  Eigen::MatrixXd base() const override { return Eigen::MatrixXd::Identity(this->dim(), this->dim()); }
  template <class Jet>
  Jet squared_index(std::span<const Jet> x) const {
    return Jet(1.0) / this->function().energy.squared_speed(x);
  }
};

template <int D>
std::shared_ptr<const SegmentCost> made(PotentialLevel energy, int dim) {
  return std::make_shared<PotentialTimeCost<D>>(PotentialChute<D>{std::move(energy)}, dim);
}

}  // namespace

std::shared_ptr<const SegmentCost> make_potential_time_cost(const BeadInPotential& bead, int dim,
                                                            const std::optional<Eigen::VectorXd>& source) {
  PotentialLevel energy{
      Formula(formulas_of_option("potential", {bead.potential}, coordinate_names(dim), bead.parameters)),
      bead.level.value_or(0)};
  if (!bead.level) {
    const double at_source = energy.potential(std::span<const double>(source->data(), static_cast<std::size_t>(dim)));
    energy.level = at_source + bead.start_speed * bead.start_speed / 2;
    if (!std::isfinite(energy.level)) throw OptionError("potential", "is not finite at the source");
  }
  if (dim == 2) return made<2>(std::move(energy), dim);
  if (dim == 3) return made<3>(std::move(energy), dim);
  return made<Eigen::Dynamic>(std::move(energy), dim);
}

}  // namespace leastcost
