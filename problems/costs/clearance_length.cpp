// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/clearance_length.hpp>

#include <cmath>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include "framework/base/counted.hpp"

namespace leastcost {
namespace {

constexpr double kStepOfReach = 1e-4;  ///< of the differences of slopes

/// How often a number was differentiated.
template <class S>
constexpr int kOrder = 0;
template <class S, int N>
constexpr int kOrder<Dual<S, N>> = 1 + kOrder<S>;

/// What a length is multiplied by at a place, with its derivatives.
struct Factor {
  double value = 1;
  Eigen::VectorXd gradient = {};
  Eigen::MatrixXd hessian = {};
};

class Softness {
 public:
  Softness(const ClearanceLengthOptions& options, std::shared_ptr<const Walls> walls)
      : weight_(options.weight), reach_(options.reach), walls_(std::move(walls)) {}

  Factor at(const Eigen::VectorXd& x, int order) const {
    Factor f;
    if (order == 0) {
      std::vector<Wall> found;
      walls_->near(x, reach_, found);
      for (const Wall& wall : found) f.value += weight_ * std::pow(std::max(0.0, 1 - wall.gap / reach_), 3);
      return f;
    }
    f.gradient = gradient(x, f.value);
    if (order == 1) return f;
    const double step = kStepOfReach * reach_;
    f.hessian.resize(x.size(), x.size());
    double value = 0;
    Eigen::VectorXd moved = x;
    for (Index i = 0; i < x.size(); ++i) {
      moved[i] = x[i] + step;
      f.hessian.col(i) = gradient(moved, value);
      moved[i] = x[i] - step;
      f.hessian.col(i) = (f.hessian.col(i) - gradient(moved, value)).eval() / (2 * step);
      moved[i] = x[i];
    }
    f.hessian = (f.hessian + f.hessian.transpose()).eval() / 2;
    return f;
  }

 private:
  Eigen::VectorXd gradient(const Eigen::VectorXd& x, double& value) const {
    std::vector<Wall> found;
    walls_->near(x, reach_, found);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(x.size());
    value = 1;
    for (const Wall& wall : found) {
      const double s = std::max(0.0, 1 - wall.gap / reach_);
      value += weight_ * s * s * s;
      sum -= 3 * weight_ * s * s / reach_ * wall.slope;
    }
    return sum;
  }

  double weight_, reach_;
  std::shared_ptr<const Walls> walls_;
};

template <int D>
struct ClearanceLength {
  static constexpr int dim = D;
  Softness softness;

  CostTraits traits() const { return {.unit = "length", .symmetric = true}; }

  /// The factor by its Taylor polynomial at the place itself: exact for as many derivatives as S has.
  template <class S>
  S factor(const Point<S, D>& x) const {
    Eigen::VectorXd place(x.size());
    for (Index i = 0; i < x.size(); ++i) place[i] = innermost(x[i]);
    const Factor f = softness.at(place, kOrder<S>);
    S sum(f.value);
    if constexpr (kOrder < S >> 0)
      for (Index i = 0; i < x.size(); ++i) {
        const S by = x[i] - S(place[i]);
        sum += by * f.gradient[i];
        if constexpr (kOrder < S >> 1)
          for (Index j = 0; j < x.size(); ++j) sum += by * (x[j] - S(place[j])) * (0.5 * f.hessian(i, j));
      }
    return sum;
  }

  template <class S>
  Point<S, D> residual(const Point<S, D>& a, const Point<S, D>& b) const {
    const Point<S, D> middle = 0.5 * (a + b);
    const S by = factor<S>(middle);
    return (b - a) * by;
  }
  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    return residual<S>(a, b).squaredNorm();
  }
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    return v.norm() * softness.at(x, 0).value;
  }
};

}  // namespace

void ClearanceLengthOptions::fields(FieldVisitor& visit) {
  visit.field("weight", weight, {.help = "Extra cost per unit of length in contact with an obstacle.", .minimum = 0});
  visit.field("reach", reach,
              {.help = "Distance, beyond the clearance, at which the extra cost of an obstacle ends.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
}

std::shared_ptr<const SegmentCost> make_clearance_length(const ClearanceLengthOptions& options, int dim,
                                                         std::shared_ptr<const Walls> walls) {
  if (!(options.weight >= 0) || !std::isfinite(options.weight))
    throw OptionError("weight", "must be a number, at least 0");
  if (!(options.reach > 0) || !std::isfinite(options.reach))
    throw OptionError("reach", "must be a number greater than 0");
  if (walls->dimension() != dim)
    throw InputError("the obstacles have " + counted(walls->dimension(), "dimension") + ", but the space has " +
                     std::to_string(dim));
  const Softness softness(options, std::move(walls));
  if (dim == 2) return make_segment_cost(ClearanceLength<2>{softness});
  if (dim == 3) return make_segment_cost(ClearanceLength<3>{softness});
  return make_segment_cost(ClearanceLength<Eigen::Dynamic>{softness}, dim);
}

std::shared_ptr<const SegmentCost> make_clearance_length(const ClearanceLengthOptions& options, int dim,
                                                         const std::shared_ptr<const ConstraintManifold>& domain) {
  const auto* walled = domain != nullptr ? find_ability<HasWalls>(*domain) : nullptr;
  if (walled == nullptr) throw OptionError("type", "'clearance' needs obstacles, but there are none");
  return make_clearance_length(options, dim, std::shared_ptr<const Walls>(domain, &walled->walls()));
}

}  // namespace leastcost
