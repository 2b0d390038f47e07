// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/layers.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include "framework/base/counted.hpp"
#include "problems/layers/snell.hpp"

namespace leastcost {
namespace {

template <int D>
struct LayersFunction {
  static constexpr int dim = D;
  LayerStack stack;
  std::string unit;

  CostTraits traits() const { return {.unit = unit, .symmetric = true, .additive = true}; }

  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    const S squared = (b - a).squaredNorm();
    const Eigen::VectorXd from = plain(a), to = plain(b);
    if (const auto layer = stack.layer_of_leg(from, to)) return squared * (stack.index(*layer) * stack.index(*layer));
    const auto first = stack.layer_of(from), last = stack.layer_of(to);
    if (!first || !last) return S(std::numeric_limits<double>::infinity());
    const int up = *last > *first ? 1 : -1;
    S mean = S(0.0), before = S(0.0);  // index over the move; the part of it before the next interface
    for (int layer = *first; layer != *last; layer += up) {
      const int k = std::min(layer, layer + up);
      const S below = height(k, a), above = height(k, b);
      const S part = below / (below - above);
      if (innermost(part) < innermost(before) - kRounding) return S(std::numeric_limits<double>::infinity());
      mean += stack.index(layer) * (part - before);
      before = part;
    }
    mean += stack.index(*last) * (1.0 - before);
    return squared * mean * mean;
  }

  /// On an interface it is that of the layer into which v points, along it the lower index.
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    const std::vector<int> at = stack.layers_at(x);
    if (at.empty()) return std::numeric_limits<double>::infinity();
    int layer = at.front();
    for (int k = at.front(); k < at.back(); ++k) {
      const double across = stack.normal(k).dot(v);
      if (std::abs(across) <= kRounding * v.norm()) return v.norm() * std::min(stack.index(k), stack.index(k + 1));
      if (across > 0) layer = k + 1;
    }
    return v.norm() * stack.index(layer);
  }

  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return stack.layer_of(a) && stack.layer_of(b) ? "the interfaces of the layers cross on this move"
                                                  : "there is no layer here: the interfaces have crossed";
  }

 private:
  static constexpr double kRounding = 1e-12;

  template <class S>
  static Eigen::VectorXd plain(const Point<S, D>& x) {
    Eigen::VectorXd out(x.size());
    for (Index i = 0; i < x.size(); ++i) out[i] = innermost(x[i]);
    return out;
  }
  template <class S>
  S height(int k, const Point<S, D>& x) const {
    S sum = S(-stack.offset(k));
    for (Index i = 0; i < x.size(); ++i) sum += stack.normal(k)[i] * x[i];
    return sum;
  }
};

template <int D>
class LayersCostOf final : public SegmentCostOf<LayersFunction<D>, LayersCost> {
  using Base = SegmentCostOf<LayersFunction<D>, LayersCost>;

 public:
  LayersCostOf(LayerStack stack, std::string unit) : Base({stack, std::move(unit)}, stack.dimension()) {}
  const LayerStack& layers() const override { return this->function().stack; }
};

/// One row for all, or one each, as columns.
Eigen::MatrixXd normals_of(const LayersOptions& options, int dim) {
  const Index count = options.interfaces.size();
  if (!options.normals) return Eigen::VectorXd::Unit(dim, dim - 1).replicate(1, count);
  const Eigen::MatrixXd& given = *options.normals;
  if (given.cols() != dim)
    throw OptionError("normals", "has rows of " + std::to_string(given.cols()) +
                                     " numbers, but the space has dimension " + std::to_string(dim));
  if (given.rows() == 1) return given.transpose().replicate(1, count);
  if (given.rows() == count) return given.transpose();
  throw OptionError("normals", "has " + std::to_string(given.rows()) + " rows: give one for all interfaces, or " +
                                   std::to_string(count) + ", one for each");
}

Eigen::VectorXd indices_of(const LayersOptions& options) {
  if (options.speeds.has_value() == options.indices.has_value())
    throw OptionError("speeds", "give either 'speeds' or 'indices', one number for each layer, lowest first");
  if (options.indices) return *options.indices;
  const Eigen::VectorXd& speeds = *options.speeds;
  if (speeds.size() != options.interfaces.size() + 1)
    throw OptionError("speeds", "has " + counted(speeds.size(), "number") + ", but must have one for each of the " +
                                    counted(options.interfaces.size() + 1, "layer") + ": one more than interfaces");
  for (Index i = 0; i < speeds.size(); ++i)
    if (!(speeds[i] > 0) || !std::isfinite(speeds[i]))
      throw OptionError("speeds", "number " + std::to_string(i + 1) + " must be greater than 0, and finite");
  return speeds.cwiseInverse();
}

}  // namespace

std::vector<Crossing> LayersCost::crossings(const Points& polyline, const ConstraintManifold&) const {
  return measure_crossings(layers(), polyline);
}

void LayersOptions::fields(FieldVisitor& visit) {
  visit.field("interfaces", interfaces,
              {.help = "Positions of the interfaces, lowest first: normal . x = this number (heights, if the normal is "
                       "the last axis).",
               .unit = "length",
               .required = true});
  visit.field("speeds", speeds,
              {.help = "Speed in each layer, lowest first; one more than interfaces.", .unit = "length/s"});
  visit.field("indices", indices,
              {.help = "Instead of speeds: cost per unit of length in each layer (refractive index)."});
  visit.field("normals", normals,
              {.help = "Upward normals of the interfaces, one row for all or one for each (dipping layers); default: "
                       "the last axis."});
}

std::shared_ptr<const LayersCost> make_layers_cost(const LayersOptions& options, int dim) {
  if (dim < 2) throw OptionError("interfaces", "layers need a space of at least two dimensions");
  if (options.interfaces.size() == 0) throw OptionError("interfaces", "missing: give at least one interface");
  const Eigen::VectorXd indices = indices_of(options);
  LayerStack stack(normals_of(options, dim), options.interfaces, indices);
  const std::string unit = options.speeds ? "s" : "length";
  if (dim == 2) return std::make_shared<LayersCostOf<2>>(std::move(stack), unit);
  if (dim == 3) return std::make_shared<LayersCostOf<3>>(std::move(stack), unit);
  return std::make_shared<LayersCostOf<Eigen::Dynamic>>(std::move(stack), unit);
}

}  // namespace leastcost
