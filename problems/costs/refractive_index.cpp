// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/refractive_index.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_free_places.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/point_text.hpp"
#include "problems/costs/isotropic_length.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "problems/formula/formula.hpp"

namespace leastcost {
namespace {

using std::sqrt, std::pow, std::tanh;

/// |x - center|^2 / radius^2.
template <class S>
S squared_radius(std::span<const S> x, const std::vector<double>& center, double radius) {
  S sum(0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const S d = x[i] - S(center[i]);
    if constexpr (IntervalBased<S>)
      sum += square(d);
    else
      sum += d * d;
  }
  return sum * S(1 / (radius * radius));
}

template <class S>
S along(std::span<const S> x, const std::vector<double>& direction) {
  S sum(0.0);
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * S(direction[i]);
  return sum;
}

struct LinearSpeed {
  double speed;
  std::vector<double> gradient;
  std::string unit() const { return "time"; }
  std::string outside() const { return "the speed is not positive"; }
  template <class S>
  S operator()(std::span<const S> x) const {
    return S(1.0) / S(S(speed) + along(x, gradient));
  }
};

struct LuneburgIndex {
  double radius;
  std::vector<double> center;
  std::string unit() const { return "optical length"; }
  std::string outside() const { return "n is not defined beyond sqrt 2 radii from the centre of the lens"; }
  template <class S>
  S operator()(std::span<const S> x) const {
    return sqrt(S(S(2.0) - squared_radius(x, center, radius)));
  }
};

struct FisheyeIndex {
  double peak, radius;
  std::vector<double> center;
  std::string unit() const { return "optical length"; }
  std::string outside() const { return "n is not finite"; }
  template <class S>
  S operator()(std::span<const S> x) const {
    return S(peak) / S(S(1.0) + squared_radius(x, center, radius));
  }
};

/// values[0] + sum_i (values[i + 1] - values[i]) step_i: a mean of the values, hence between them.
struct LayeredIndex {
  std::vector<double> boundaries, values, normal;
  double width;
  bool speeds;
  std::string unit() const { return speeds ? "time" : "optical length"; }
  std::string outside() const { return "n is not finite"; }
  template <class S>
  S operator()(std::span<const S> x) const {
    const S depth = along(x, normal);
    S value(values[0]);
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
      const S step = S(1.0) + tanh(S((depth - S(boundaries[i])) * S(1 / width)));
      value += step * S(0.5 * (values[i + 1] - values[i]));
    }
    return speeds ? S(S(1.0) / value) : value;
  }
};

struct PowerIndex {
  double exponent, level;
  std::string unit() const { return "optical length"; }
  std::string outside() const {
    return exponent > 0 ? "the last coordinate is below the level of n = y^k"
                        : "the last coordinate is not above the level of n = y^k, where n is infinite";
  }
  template <class S>
  S operator()(std::span<const S> x) const {
    const S y = x.back() - S(level);
    if constexpr (IntervalBased<S>) {
      if (!(y > S(0.0))) return S(Interval::all());
    } else {
      if (innermost(y) < 0) return S(-1.0);
    }
    return pow(y, exponent);
  }
};

struct FormulaIndex {
  Formula formula;
  std::string unit() const { return "optical length"; }
  std::string outside() const { return "the formula of n is not positive"; }
  template <class S>
  S operator()(std::span<const S> x) const {
    return formula(x);
  }
};

using AnyIndex = std::variant<LinearSpeed, LuneburgIndex, FisheyeIndex, LayeredIndex, PowerIndex, FormulaIndex>;

/// What IsotropicLength asks of an index.
struct NamedIndex {
  AnyIndex any;

  template <class S>
  S operator()(std::span<const S> x) const {
    return std::visit([&](const auto& n) -> S { return n(x); }, any);
  }
  std::string unit() const {
    return std::visit([](const auto& n) { return n.unit(); }, any);
  }
  std::string why_outside(std::span<const double> x) const {
    const auto* formula = std::get_if<FormulaIndex>(&any);
    if (formula == nullptr) return std::visit([](const auto& n) { return n.outside(); }, any);
    const double n = (*formula)(x);
    if (std::isnan(n)) return "the formula of n has no value";
    return (n < 0 && std::isfinite(n) ? formula->outside() : "the formula of n is not finite") +
           ": n = " + short_number(n, 6);
  }
};

/// Where n = y^k vanishes moves are free.
template <int D>
class RefractiveIndexCost final : public IsotropicLengthCost<NamedIndex, D>, public HasFreePlaces {
 public:
  using IsotropicLengthCost<NamedIndex, D>::IsotropicLengthCost;

  bool present() const override {
    const PowerIndex* n = power();
    return n != nullptr && n->exponent > 0;
  }
  double distance_to_free(const Eigen::VectorXd& x) const override { return x[x.size() - 1] - power()->level; }

  /// Straight down, which costs y^(k + 1) / (k + 1), along y = 0, and up.
  FreePassage free_passage(const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                           Index segments) const override {
    const double power_of_cost = power()->exponent + 1;
    const double down = std::pow(distance_to_free(source), power_of_cost) / power_of_cost,
                 up = std::pow(distance_to_free(target), power_of_cost) / power_of_cost;
    const auto share = static_cast<Index>(std::lround(static_cast<double>(segments - 1) * down / (down + up)));
    const Index before = std::clamp<Index>(share, 1, segments - 2), after = segments - 1 - before;
    FreePassage out{Points(source.size(), segments + 1), before, down + up};
    const auto height = [&](const Eigen::VectorXd& end, Index step, Index steps) {
      const double left = 1 - static_cast<double>(step) / static_cast<double>(steps);  // of the cost
      return power()->level + distance_to_free(end) * std::pow(left, 1 / power_of_cost);
    };
    for (Index i = 0; i <= before; ++i) {
      out.points.col(i) = source;
      out.points(source.size() - 1, i) = height(source, i, before);
    }
    for (Index i = 0; i <= after; ++i) {
      out.points.col(segments - i) = target;
      out.points(source.size() - 1, segments - i) = height(target, i, after);
    }
    return out;
  }

 private:
  const PowerIndex* power() const { return std::get_if<PowerIndex>(&this->function().n.any); }
};

template <int D>
std::shared_ptr<const SegmentCost> with_index(NamedIndex n, int dim) {
  return std::make_shared<RefractiveIndexCost<D>>(IsotropicLength<NamedIndex, D>{std::move(n)}, dim);
}

std::string key(const char* option) { return std::string("index.") + option; }

void require_positive(const char* option, double value) {
  if (!(value > 0) || !std::isfinite(value)) throw OptionError(key(option), "must be a number greater than 0");
}

std::vector<double> list(const Eigen::VectorXd& x) { return {x.data(), x.data() + x.size()}; }

/// As many numbers as there are coordinates; an empty list stands for `otherwise`.
std::vector<double> of_dimension(const char* option, const Eigen::VectorXd& x, int dim,
                                 const Eigen::VectorXd& otherwise) {
  if (x.size() == 0) return list(otherwise);
  if (x.size() != dim)
    throw OptionError(key(option), "has " + std::to_string(x.size()) + " numbers, but the space has " +
                                       std::to_string(dim) + " coordinates");
  if (!x.allFinite()) throw OptionError(key(option), "must be finite");
  return list(x);
}

/// Makes the index that was chosen.
struct IndexMaker {
  int dim;

  AnyIndex operator()(const refraction::LinearVelocity& o) const {
    if (o.gradient.size() == 0) throw OptionError(key("gradient"), "missing: one number per coordinate");
    if (!std::isfinite(o.speed)) throw OptionError(key("speed"), "must be finite");
    return LinearSpeed{o.speed, of_dimension("gradient", o.gradient, dim, {})};
  }
  AnyIndex operator()(const refraction::Luneburg& o) const {
    require_positive("radius", o.radius);
    return LuneburgIndex{o.radius, of_dimension("center", o.center, dim, Eigen::VectorXd::Zero(dim))};
  }
  AnyIndex operator()(const refraction::MaxwellFisheye& o) const {
    require_positive("peak", o.peak);
    require_positive("radius", o.radius);
    return FisheyeIndex{o.peak, o.radius, of_dimension("center", o.center, dim, Eigen::VectorXd::Zero(dim))};
  }
  AnyIndex operator()(const refraction::SmoothLayers& o) const {
    require_positive("width", o.width);
    if (o.boundaries.size() == 0) throw OptionError(key("boundaries"), "missing: give at least one boundary");
    if (o.values.size() != o.boundaries.size() + 1)
      throw OptionError(key("values"), "has " + counted(static_cast<long>(o.values.size()), "number") +
                                           ", but must have one for each of the " +
                                           counted(static_cast<long>(o.boundaries.size()) + 1, "layer") +
                                           ": one more than boundaries");
    for (Eigen::Index i = 0; i + 1 < o.boundaries.size(); ++i)
      if (!(o.boundaries[i] < o.boundaries[i + 1])) throw OptionError(key("boundaries"), "must increase");
    for (const double value : o.values) require_positive("values", value);
    std::vector<double> normal = of_dimension("normal", o.normal, dim, Eigen::VectorXd::Unit(dim, dim - 1));
    const double length = Eigen::Map<const Eigen::VectorXd>(normal.data(), dim).norm();
    if (!(length > 0)) throw OptionError(key("normal"), "has no direction: it is zero");
    for (double& component : normal) component /= length;
    return LayeredIndex{list(o.boundaries), list(o.values), std::move(normal), o.width,
                        o.values_are == refraction::LayerValues::speed};
  }
  AnyIndex operator()(const refraction::PowerLaw& o) const {
    if (!std::isfinite(o.exponent)) throw OptionError(key("exponent"), "must be finite");
    if (!std::isfinite(o.level)) throw OptionError(key("level"), "must be finite");
    return PowerIndex{o.exponent, o.level};
  }
  AnyIndex operator()(const refraction::Formula& o) const {
    try {
      return FormulaIndex{Formula(formulas_of_option("n", {o.n}, coordinate_names(dim), o.parameters))};
    } catch (const OptionError& error) {
      throw error.under("index");
    }
  }
};

}  // namespace

Words<refraction::LayerValues> refraction::words(LayerValues) {
  static constexpr std::array<Word<LayerValues>, 2> kWords = {
      {{LayerValues::index, "index"}, {LayerValues::speed, "speed"}}};
  return kWords;
}

void refraction::LinearVelocity::fields(FieldVisitor& visit) {
  visit.field("speed", speed, {.help = "Speed at the origin.", .unit = "length/time"});
  visit.field("gradient", gradient,
              {.help = "Gradient of the speed, one number per coordinate.", .unit = "1/time", .required = true});
}

void refraction::Luneburg::fields(FieldVisitor& visit) {
  visit.field("radius", radius,
              {.help = "Radius at which n = 1.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
  visit.field("center", center, {.help = "Centre of the lens; default: the origin.", .unit = "length"});
}

void refraction::MaxwellFisheye::fields(FieldVisitor& visit) {
  visit.field("peak", peak, {.help = "n at the centre.", .minimum = 0, .exclusive_minimum = true});
  visit.field(
      "radius", radius,
      {.help = "Radius at which n is half its peak.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
  visit.field("center", center, {.help = "Centre of the lens; default: the origin.", .unit = "length"});
}

void refraction::SmoothLayers::fields(FieldVisitor& visit) {
  visit.field("boundaries", boundaries,
              {.help = "Positions along the normal where one layer ends and the next begins, increasing.",
               .unit = "length",
               .required = true});
  visit.field("values", values,
              {.help = "Values in the layers, one more than boundaries.",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
  visit.choice("values_are", values_are, {.help = "Whether the values are indices n, or speeds 1 / n."});
  visit.field("width", width,
              {.help = "Half the range over which a step covers 76 % of its height: (1 + tanh(d / width)) / 2.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
  visit.field("normal", normal, {.help = "Normal of the layers; default: along the last coordinate."});
}

void refraction::PowerLaw::fields(FieldVisitor& visit) {
  visit.field("exponent", exponent, {.help = "The exponent k in n = y^k.", .required = true});
  visit.field("level", level, {.help = "Value of the last coordinate where y is 0.", .unit = "length"});
}

void refraction::Formula::fields(FieldVisitor& visit) {
  visit.field("n", n, {.help = "n(x) > 0, like \"1 + 2 * exp(-x^2 - y^2)\".", .required = true});
  visit.field("parameters", parameters, {.help = "Constants that the formula can use, like {a: 2, b: 1}."});
}

void RefractiveIndexOptions::fields(FieldVisitor& visit) {
  visit.variant("index", index, {.help = "The refractive index n(x), by name or as a formula.", .required = true});
}

std::shared_ptr<const SegmentCost> make_refractive_index_cost(const RefractiveIndexOptions& options, int dim) {
  if (dim < 1) throw OptionError("index", "the space must have at least one dimension");
  NamedIndex n{std::visit(IndexMaker{dim}, options.index)};
  if (dim == 2) return with_index<2>(std::move(n), dim);
  if (dim == 3) return with_index<3>(std::move(n), dim);
  return with_index<Eigen::Dynamic>(std::move(n), dim);
}

}  // namespace leastcost
