// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/travel_time.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/cost/starts_straight.hpp>
#include "framework/base/counted.hpp"
#include "problems/costs/potential_time.hpp"

namespace leastcost {
namespace {

/// Speed at a height, v^2 = 2 g (level - height): energy is conserved along the whole path.
struct EnergyLevel {
  double gravity, level;
  template <class S>
  S squared_speed(const S& height) const {
    return 2 * gravity * (level - height);
  }
};

template <int D>
struct TravelTimeBase {
  static constexpr int dim = D;
  EnergyLevel energy;
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    const double v2 = energy.squared_speed(x[x.size() - 1]);
    return v2 > 0 ? v.norm() / std::sqrt(v2) : std::numeric_limits<double>::infinity();
  }
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const double highest = std::max(a[a.size() - 1], b[b.size() - 1]);
    if (highest < energy.level) return "";
    std::ostringstream out;
    out << "the height " << highest << (highest > energy.level ? " is above" : " is that of") << " the energy level "
        << energy.level << ", the largest height that the bead can reach";
    return out.str();
  }
};

/// Exact time of a straight chute: the acceleration is constant, so the mean speed is that of its ends.
template <int D>
struct Chute : TravelTimeBase<D> {
  CostTraits traits() const { return {.unit = "s", .symmetric = true, .additive = true}; }

  template <class S>
  S speed_sum(const Point<S, D>& a, const Point<S, D>& b) const {
    using std::sqrt;
    const S va2 = this->energy.squared_speed(a[a.size() - 1]), vb2 = this->energy.squared_speed(b[b.size() - 1]);
    if (va2 < S(0.0) || vb2 < S(0.0)) return S(0.0);
    return sqrt(va2) + sqrt(vb2);
  }
  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    const S length2 = (b - a).squaredNorm(), speed = speed_sum<S>(a, b);
    if (innermost(speed) > 0) return 4 * length2 / (speed * speed);
    return S(a == b ? 0.0 : std::numeric_limits<double>::infinity());
  }
  template <class S>
  Point<S, D> residual(const Point<S, D>& a, const Point<S, D>& b) const {
    return (b - a) * (S(2.0) / speed_sum<S>(a, b));
  }

  /// By hand, because nested duals made two thirds of a Newton step: q = f(S) L with L = |b - a|^2, f = 4 / S^2 and S
  /// the sum of the speeds, which depends on the two heights alone. An end at rest has infinite derivatives; they stay
  /// in its own rows and columns.
  void hessian(const Point<double, D>& a, const Point<double, D>& b, Eigen::Ref<Points> h) const {
    const Index d = a.size();
    const Index height[] = {d - 1, 2 * d - 1};
    const double g = this->energy.gravity;
    const double speed[] = {std::sqrt(this->energy.squared_speed(a[d - 1])),
                            std::sqrt(this->energy.squared_speed(b[d - 1]))};
    const double sum = speed[0] + speed[1], f = 4 / (sum * sum), f1 = -2 * f / sum, f2 = -3 * f1 / sum;
    const Point<double, D> u = b - a;
    const double length2 = u.squaredNorm();
    h.diagonal().array() += 2 * f;
    h.topRightCorner(d, d).diagonal().array() -= 2 * f;
    h.bottomLeftCorner(d, d).diagonal().array() -= 2 * f;
    for (int e = 0; e < 2; ++e) {
      const Index y = height[e];
      const double slope = -g / speed[e];  // of S
      for (Index i = 0; i < d; ++i) {
        const double product = 2 * f1 * slope * u[i];  // of grad f and grad L
        h(y, i) -= product, h(i, y) -= product;
        h(y, d + i) += product, h(d + i, y) += product;
      }
      h(y, y) += length2 * (f2 * slope * slope - f1 * g * g / (speed[e] * speed[e] * speed[e]));
      h(y, height[1 - e]) += length2 * f2 * slope * -g / speed[1 - e];
    }
  }
};

/// Speed at mid-height, VFCS Eqs. (21), (22). From rest it is not the time of the chute: see docs/numerics.md Sec. 2.1.
template <int D>
struct Midpoint : TravelTimeBase<D> {
  CostTraits traits() const { return {.unit = "s", .symmetric = true}; }

  /// Negative also where one end alone lies above the level, although the mid-height does not.
  template <class S>
  S squared_speed(const Point<S, D>& a, const Point<S, D>& b) const {
    const S &ya = a[a.size() - 1], &yb = b[b.size() - 1];
    if (innermost(ya) > this->energy.level || innermost(yb) > this->energy.level) return S(-1.0);
    return this->energy.squared_speed(S((ya + yb) * 0.5));
  }
  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    const S v2 = squared_speed<S>(a, b);
    if (innermost(v2) > 0) return (b - a).squaredNorm() / v2;
    return S(a == b ? 0.0 : std::numeric_limits<double>::infinity());
  }
  template <class S>
  Point<S, D> residual(const Point<S, D>& a, const Point<S, D>& b) const {
    using std::sqrt;
    return (b - a) * (S(1.0) / sqrt(squared_speed<S>(a, b)));
  }
};

/// Both rules are the length under the metric I / v^2 in the limit of short segments.
template <class Rule>
class TravelTimeCost final : public SegmentCostOf<Rule>,
                             public ConformalMetricBy<TravelTimeCost<Rule>>,
                             public StartsStraight {
 public:
  using SegmentCostOf<Rule>::SegmentCostOf;

  Eigen::MatrixXd base() const override { return Eigen::MatrixXd::Identity(this->dim(), this->dim()); }
  template <class Jet>
  Jet squared_index(std::span<const Jet> x) const {
    return Jet(1.0) / this->function().energy.squared_speed(x.back());
  }
};

template <template <int> class Rule>
std::shared_ptr<const SegmentCost> make_rule(const EnergyLevel& energy, int dim) {
  if (dim == 2) return std::make_shared<TravelTimeCost<Rule<2>>>(Rule<2>{{energy}});
  if (dim == 3) return std::make_shared<TravelTimeCost<Rule<3>>>(Rule<3>{{energy}});
  return make_segment_cost(Rule<Eigen::Dynamic>{{energy}}, dim);
}

}  // namespace

Words<TravelTimeRule> words(TravelTimeRule) {
  static constexpr std::array<Word<TravelTimeRule>, 2> kWords = {
      {{TravelTimeRule::chute, "chute"}, {TravelTimeRule::midpoint, "midpoint"}}};
  return kWords;
}

void TravelTimeOptions::fields(FieldVisitor& visit) {
  visit.choice("rule", rule,
               {.help = "chute: exact time of a straight chute; midpoint: speed at mid-height, VFCS Eq. (21)."});
  visit.field("gravity", gravity,
              {.help = "Gravitational acceleration; the last coordinate is height, up is positive.",
               .unit = "length/s^2",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field("start_speed", start_speed, {.help = "Speed at the source.", .unit = "length/s", .minimum = 0});
  visit.field("level", level,
              {.help = "Height at which the bead is at rest, or its energy in a potential; default: from the source "
                       "and the start speed. Required for a ring without a source.",
               .unit = "length, in a potential length^2/s^2"});
  visit.field(
      "potential", potential,
      {.help = "Instead of gravity: the potential energy per mass as a formula in the coordinates, like \"(x^2 + "
               "y^2) / 2\".",
       .unit = "length^2/s^2"});
  visit.field("parameters", parameters, {.help = "Constants that the potential can use, like {k: 2}."});
}

void check_travel_time(const TravelTimeOptions& options, bool has_source) {
  if (options.level && options.start_speed > 0)
    throw OptionError("start_speed", "the start speed determines the energy level: give either start_speed or level");
  if (options.level && !std::isfinite(*options.level)) throw OptionError("level", "must be finite");
  if (!options.level && !has_source)
    throw OptionError("level", "a ring without a source needs it: give the energy level (a height)");
  if (!options.potential) {
    if (!options.parameters.empty()) throw OptionError("parameters", "are constants of a potential, but there is none");
    return;
  }
  if (options.gravity != TravelTimeOptions{}.gravity)
    throw OptionError("gravity",
                      "give either gravity or potential: gravity can be part of the potential, like \"9.8 * y\"");
  if (options.rule != TravelTimeRule::chute) throw OptionError("rule", "must be chute in a potential");
}

std::shared_ptr<const SegmentCost> make_travel_time_cost(const TravelTimeOptions& options, int dim,
                                                         const std::optional<Eigen::VectorXd>& source) {
  check_travel_time(options, source.has_value());
  if (dim < 1) throw OptionError("dimension", "the space must have at least one dimension");
  if (source && source->size() != dim)
    throw InputError("the source has " + counted(source->size(), "coordinate") + ", but the space has " +
                     std::to_string(dim));
  if (options.potential)
    return make_potential_time_cost({*options.potential, options.parameters, options.start_speed, options.level}, dim,
                                    source);
  const double level = options.level
                           ? *options.level
                           : (*source)[dim - 1] + options.start_speed * options.start_speed / (2 * options.gravity);
  const EnergyLevel energy{options.gravity, level};
  switch (options.rule) {
    case TravelTimeRule::chute: return make_rule<Chute>(energy, dim);
    case TravelTimeRule::midpoint: return make_rule<Midpoint>(energy, dim);
  }
  throw OptionError("rule", "is not a rule of travel_time");
}

}  // namespace leastcost
