// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/weighted_length.hpp>

#include <cmath>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/domain/has_blocks.hpp>

namespace leastcost {
namespace {

template <int D>
struct WeightedLength {
  static constexpr int dim = D;
  Point<double, D> w;  ///< of the coordinates

  CostTraits traits() const { return {.unit = "length", .symmetric = true, .additive = true, .below_curves = true}; }

  template <class S>
  Point<S, D> residual(const Point<S, D>& a, const Point<S, D>& b) const {
    return w.template cast<S>().cwiseProduct(b - a);
  }
  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    return residual<S>(a, b).squaredNorm();
  }
  double gradient(const Point<double, D>& a, const Point<double, D>& b, Point<double, D>& ga,
                  Point<double, D>& gb) const {
    const Point<double, D> r = w.cwiseProduct(b - a);
    gb = 2 * w.cwiseProduct(r);
    ga = -gb;
    return r.squaredNorm();
  }
  void hessian(const Point<double, D>& a, const Point<double, D>&, Eigen::Ref<Points> h) const {
    const Index d = a.size();
    const Point<double, D> twice = 2 * w.cwiseProduct(w);
    h.diagonal().head(d) = h.diagonal().tail(d) = twice;
    h.topRightCorner(d, d).diagonal() = h.bottomLeftCorner(d, d).diagonal() = -twice;
  }
  double line_element(const Eigen::VectorXd&, const Eigen::VectorXd& v) const { return w.cwiseProduct(v).norm(); }
};

template <int D>
class WeightedLengthCost final : public SegmentCostOf<WeightedLength<D>, ConstantMetricCost> {
  using Base = SegmentCostOf<WeightedLength<D>, ConstantMetricCost>;

 public:
  explicit WeightedLengthCost(const Eigen::VectorXd& w) : Base({w}, static_cast<int>(w.size())) {}
  Eigen::MatrixXd metric() const override { return Eigen::VectorXd(this->function().w).cwiseAbs2().asDiagonal(); }
};

void check_weights(const Eigen::VectorXd& weights) {
  for (Index i = 0; i < weights.size(); ++i)
    if (!(weights[i] > 0) || !std::isfinite(weights[i]))
      throw OptionError("weights",
                        "number " + std::to_string(i + 1) + " must be greater than 0, or paths could cost nothing");
}

/// The weights of all coordinates.
Eigen::VectorXd of_coordinates(const Eigen::VectorXd& weights, const ConstraintManifold& domain) {
  const auto* divided = find_ability<HasBlocks>(domain);
  const std::vector<CoordinateBlock> blocks = divided != nullptr ? divided->blocks() : std::vector<CoordinateBlock>();
  const Index dimension = domain.dimensions().ambient, count = static_cast<Index>(blocks.size());
  if (weights.size() == count) {
    Eigen::VectorXd all(dimension);
    for (Index k = 0; k < count; ++k) {
      const CoordinateBlock& block = blocks[static_cast<std::size_t>(k)];
      all.segment(block.first, block.size).setConstant(weights[k] * block.unit);
    }
    return all;
  }
  if (weights.size() == dimension) return weights;
  throw OptionError("weights",
                    "has " + std::to_string(weights.size()) + " numbers; give " +
                        (count > 0 ? std::to_string(count) + ", one per factor of the domain, or " : std::string()) +
                        std::to_string(dimension) + ", one per coordinate");
}

}  // namespace

void WeightedLengthOptions::fields(FieldVisitor& visit) {
  visit.field("weights", weights,
              {.help = "One per factor of the domain (se2, se3: position, then rotation, in length per radian), or one "
                       "per coordinate.",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
}

std::shared_ptr<const ConstantMetricCost> make_weighted_length(const WeightedLengthOptions& options,
                                                               const ConstraintManifold& domain) {
  if (options.weights.size() == 0) throw OptionError("weights", "missing: give one per factor or per coordinate");
  check_weights(options.weights);
  const Eigen::VectorXd w = of_coordinates(options.weights, domain);
  if (w.size() == 2) return std::make_shared<WeightedLengthCost<2>>(w);
  if (w.size() == 3) return std::make_shared<WeightedLengthCost<3>>(w);
  return std::make_shared<WeightedLengthCost<Eigen::Dynamic>>(w);
}

}  // namespace leastcost
